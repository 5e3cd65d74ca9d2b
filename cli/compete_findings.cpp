// SPDX-License-Identifier: MIT
#include "cli/compete_findings.hpp"

#include <limits>

namespace phytobench::cli {

namespace {

/// One plant alone is neither equal to others nor unequal.
void leave_out_gini_of_one(PlantStatistics& plants) {
  if (plants.plants < 2) plants.gini = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

StandSnapshot snapshot_of(Population& population) {
  StandSnapshot snapshot{.loss = population.losses(),
                         .root_radius = population.root_radii(),
                         .crown_radius = population.crown_radii(),
                         .statistics = {}};
  const PopulationParameters& parameters = population.parameters();
  snapshot.statistics = stand_statistics(population.stand(), snapshot.loss,
                                         parameters.species.size(), parameters.ground.area());
  for (PlantStatistics& species : snapshot.statistics.species) leave_out_gini_of_one(species);
  leave_out_gini_of_one(snapshot.statistics.all);
  return snapshot;
}

std::vector<Fates> fates_of(const PopulationState& state, const std::vector<std::uint64_t>& start) {
  const std::size_t species = start.size();
  std::vector<Fates> fates(species + 1);
  for (std::size_t k = 0; k < species; ++k) {
    // What was sown counts as born there, not here.
    fates[k] = {.start = start[k], .born = state.born[k] - start[k], .died = state.died[k]};
  }
  for (const DormantSeed& seed : state.seeds) ++fates[seed.species].resting_seeds;
  for (std::size_t k = 0; k < species; ++k) {
    fates[species].start += fates[k].start;
    fates[species].born += fates[k].born;
    fates[species].died += fates[k].died;
    fates[species].resting_seeds += fates[k].resting_seeds;
  }
  return fates;
}

}  // namespace phytobench::cli
