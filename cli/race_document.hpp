// SPDX-License-Identifier: MIT
// What every document of `phytobench/race-1` begins and ends with, whatever is raced:
//   schema, workload    what was done, on what input
//   engines, ratios     lists that the race fills: one entry for each contestant, one for each pair
//   environment         what must be known to judge the times
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench::cli {

nlohmann::ordered_json race_document(nlohmann::ordered_json workload);

/// Of numbers of threads that were raced, the largest is noted. At least one.
void put_environment(nlohmann::ordered_json& document, const std::string& command_line,
                     std::uint64_t seed, std::span<const int> threads);

}  // namespace phytobench::cli
