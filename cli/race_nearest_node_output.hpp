// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "benchmarks/nearest_node/approximate_lane.hpp"
#include "benchmarks/nearest_node/race.hpp"
#include "cli/commands.hpp"
#include "cli/race_plugins.hpp"

namespace phytobench::cli {

/// Everything that a nearest-node race has to tell. Views.
struct NearestNodeRaceOutcome {
  const NearestNodeRaceOptions& options;
  const Workload& workload;
  const RaceResult& result;
  const std::vector<ApproximateEntry>& approximate;
  const std::vector<TriedPlugin>& plugins;  ///< those that got no time have an entry, too
};

/// One document of `phytobench/race-1`, with a line end.
std::string nearest_node_race_json(const NearestNodeRaceOutcome& outcome);

/// Tables for people.
std::string nearest_node_race_table(const NearestNodeRaceOutcome& outcome);

}  // namespace phytobench::cli
