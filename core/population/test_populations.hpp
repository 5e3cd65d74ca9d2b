// SPDX-License-Identifier: MIT
// Small populations for tests.
#pragma once

#include <cstdint>
#include <string>

#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"

namespace phytobench::testing_populations {

/// One woody species on a torus of 60 m, dense enough that plants meet before they are half grown.
inline PopulationParameters one_species(std::int64_t count = 60, std::uint64_t seed = 1) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.ground = {{-10.0, 5.0}, {50.0, 65.0}};
  parameters.rule = "mixture";
  parameters.species.resize(1);
  parameters.species[0].name = "shrub";
  parameters.species[0].count = count;
  return parameters;
}

/// Plants that bear seeds, rest, starve and fall ill: everything that can happen.
inline PopulationParameters lively(std::uint64_t seed = 1) {
  PopulationParameters parameters = one_species(60, seed);
  parameters.rule = "combined";
  parameters.species.push_back(parameters.species[0]);
  parameters.species[0].name = "annual";
  parameters.species[0].largest_age = 30;
  parameters.species[0].largest_radius = 0.2;
  parameters.species[0].growth_rate = 0.03;
  parameters.species[0].reproduction = {.threshold = 0.08,
                                        .seeds_per_metre = 8.0,
                                        .dispersal_distance = 6.0,
                                        .seed_mortality = 0.1,
                                        .dormant_share = 0.4,
                                        .germination_rate = 0.3,
                                        .seedling_radius = 0.02};
  parameters.species[1].name = "shrub";
  parameters.mortality = {.rule = MortalityRule::mean_relative_growth, .threshold = 0.004};
  parameters.bad_year_share = 0.2;
  parameters.illness = {.duration = 10, .is_deadly = true};
  parameters.events = {{.kind = EventKind::disease, .step = 5, .share = 0.3},
                       {.kind = EventKind::removal, .step = 12, .species = 1, .largest = 2}};
  return parameters;
}

inline Population population_of(const PopulationParameters& parameters, int threads = 1,
                                std::span<const StartPlant> plants = {}) {
  return {parameters, sow(parameters, plants), overlap_engine_named("layered_grid"), threads};
}

inline Population after(const PopulationParameters& parameters, int steps, int threads = 1) {
  Population population = population_of(parameters, threads);
  for (int i = 0; i < steps; ++i) population.step();
  return population;
}

inline bool same(const PopulationState& a, const PopulationState& b) {
  return a.step == b.step && a.next_id == b.next_id && a.stand.x == b.stand.x &&
         a.stand.y == b.stand.y && a.stand.stem_radius == b.stand.stem_radius &&
         a.stand.id == b.stand.id && a.stand.age == b.stand.age &&
         a.stand.ill_since == b.stand.ill_since && a.stand.species == b.stand.species &&
         a.recent_growth == b.recent_growth && a.seeds == b.seeds && a.born == b.born &&
         a.died == b.died;
}

}  // namespace phytobench::testing_populations
