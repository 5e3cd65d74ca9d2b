// SPDX-License-Identifier: MIT
#include "cli/race_document.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/record/environment.hpp"

namespace phytobench::cli {

using nlohmann::ordered_json;

ordered_json race_document(ordered_json workload) {
  ordered_json document;
  document["schema"] = "phytobench/race-1";
  document["workload"] = std::move(workload);
  document["engines"] = ordered_json::array();
  document["ratios"] = ordered_json::array();
  return document;
}

void put_environment(ordered_json& document, const std::string& command_line, std::uint64_t seed,
                     std::span<const int> threads) {
  document["environment"] = ordered_json::parse(
      environment_json(command_line, seed, *std::max_element(threads.begin(), threads.end())));
}

}  // namespace phytobench::cli
