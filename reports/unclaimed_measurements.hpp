// SPDX-License-Identifier: MIT
// What a run measured although no claim rests on it: "measured, not claimed".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Measurements of one experiment that stand side by side: their names differ in the last part.
struct UnclaimedGroup {
  std::string experiment;  ///< "brzoska2019/table-1"
  std::string group;       ///< "euclid.s"; empty: they stand directly below the experiment
  std::size_t count = 0;   ///< measurements of the group that no claim names, at least 1
  friend bool operator==(const UnclaimedGroup&, const UnclaimedGroup&) = default;
};

/// Recorded and timed measurements that no claim names, neither by itself nor by the start of its
/// name, grouped by all but its last part; by experiment, then by group. A timed measurement counts
/// once, however often it was timed.
std::vector<UnclaimedGroup> unclaimed_measurements(const RunContents& run,
                                                   const std::vector<const Claim*>& claims);

/// The same with the claims of all papers of a judged run.
std::vector<UnclaimedGroup> unclaimed_measurements(const JudgedRun& judged);

}  // namespace phytobench
