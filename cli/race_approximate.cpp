// SPDX-License-Identifier: MIT
#include "cli/race_approximate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/race_numbers.hpp"

namespace phytobench::cli {

namespace {

MedianOfRounds total_of(const ApproximateEntry& entry) {
  std::vector<double> seconds;
  for (const PhaseSeconds& round : entry.rounds) seconds.push_back(round.total);
  return median_of_rounds(seconds);
}

}  // namespace

nlohmann::ordered_json approximate_json(const std::vector<ApproximateEntry>& lane, int threads) {
  auto list = nlohmann::ordered_json::array();
  for (const ApproximateEntry& entry : lane) {
    nlohmann::ordered_json json{{"name", entry.engine->name},
                                {"options", entry.option},
                                {"threads", threads},
                                {"built", entry.engine->built()},
                                {"exact", false}};
    if (entry.engine->built()) {
      json["nodes"] = entry.nodes;
      put_seconds(json, total_of(entry));
      json["tree_difference"] = entry.tree_difference;
      json["wrong_answers"] = entry.wrong_answers;
    } else {
      json["missing_package"] = entry.engine->missing_package;
    }
    list.push_back(std::move(json));
  }
  return list;
}

std::string approximate_table(const std::vector<ApproximateEntry>& lane) {
  if (lane.empty()) return {};
  std::string text = fmt::format(
      "\nApproximate engines, not ranked: their trees are others\n"
      "{:<29} {:>10}  {:>9}  {:>15}  {:>13}\n",
      "engine, option", "median", "nodes", "tree difference", "wrong answers");
  for (const ApproximateEntry& entry : lane) {
    if (!entry.engine->built()) {
      text += fmt::format("{:<29} not built: {} was not found\n", entry.name(),
                          entry.engine->missing_package);
      continue;
    }
    text += fmt::format("{:<29} {:>7.1f} ms  {:>9}  {:>13.2f} %  {:>11.3f} %\n", entry.name(),
                        1e3 * total_of(entry).value, entry.nodes, 100.0 * entry.tree_difference,
                        100.0 * entry.wrong_answers);
  }
  return text;
}

}  // namespace phytobench::cli
