// SPDX-License-Identifier: MIT
// What `phytobench compete` found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/population/population.hpp"
#include "core/population/stand_statistics.hpp"

namespace phytobench::cli {

/// A stand with all that is computed from it, in the stand's order.
struct StandSnapshot {
  std::vector<double> loss, root_radius, crown_radius;
  StandStatistics statistics;  ///< Gini of fewer than two plants is NaN
};
StandSnapshot snapshot_of(Population& population);

struct CompeteFindings {
  const Population& population;
  StandSnapshot last;                   ///< of its stand
  std::vector<std::uint64_t> start;     ///< plants at the start, by species
  std::optional<StandPattern> pattern;  ///< of ten plants or more
  std::uint64_t pairs = 0;              ///< overlapping zones, over all steps
  std::vector<std::string> files;       ///< written to --out, seen from there
};

/// Plants of one species, or of all, since the start and now.
struct Fates {
  std::uint64_t start = 0, born = 0, died = 0, resting_seeds = 0;
};

/// By species, and of all at the end. `start` are plants at the start by species.
std::vector<Fates> fates_of(const PopulationState& state, const std::vector<std::uint64_t>& start);

}  // namespace phytobench::cli
