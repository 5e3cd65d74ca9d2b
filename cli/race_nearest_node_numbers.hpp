// SPDX-License-Identifier: MIT
// What the document and the table of a nearest-node race have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "benchmarks/nearest_node/race.hpp"
#include "core/statistics/median_of_rounds.hpp"

namespace phytobench::cli {

/// Of distances, to associate and to remove.
std::uint64_t evaluations(const RaceEntry& entry);

/// Seconds, over all rounds.
double median_of(const RaceEntry& entry, double PhaseSeconds::*phase);
double median_reset(const RaceEntry& entry);
MedianOfRounds total_of(const RaceEntry& entry);

/// Of totals that were timed in the same round.
MedianOfRounds ratio_of(const RaceEntry& slower, const RaceEntry& faster);

/// Timed entries, fastest first.
std::vector<const RaceEntry*> ranking(const RaceResult& result);

}  // namespace phytobench::cli
