// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// Several runs with environment.json of each ("{}" where there is none).
struct RunOrigins {
  std::span<const ComparedRun> runs;
  std::span<const std::string> environments;
  bool without_varying = false;  ///< leave out machines, commits, dates and folders
};

/// Where the runs come from, a row per fact with a cell per run; of what is the same in all runs
/// `shared` holds the one cell.
nlohmann::ordered_json run_facts(const RunOrigins& origins);

/// What a reader must know before comparing, as sentences: that the runs are of different commits,
/// changed sources, tiers, seeds or experiments, or that some name no commit, of which nothing can
/// be told then. `varies` marks what a machine or a date decides.
nlohmann::ordered_json run_warnings(const RunOrigins& origins);

}  // namespace phytobench
