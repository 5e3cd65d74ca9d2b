// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/shadow/shadow_race.hpp"
#include "cli/commands.hpp"

namespace phytobench::cli {

/// What was raced, and what was left out of it by default.
struct ShadowRaceReport {
  const ShadowWorkload* workload = nullptr;
  const ShadowRaceResult* result = nullptr;
  std::vector<std::string> left_out;
};

/// `phytobench/race-1`.
nlohmann::ordered_json shadow_race_document(const ShadowRaceReport& report,
                                            const ShadowRaceOptions& options);
std::string shadow_race_table(const ShadowRaceReport& report);

}  // namespace phytobench::cli
