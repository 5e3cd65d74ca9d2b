// SPDX-License-Identifier: MIT
// A few plants placed by hand, and what a rule says they cost each other.
#pragma once

#include <string_view>
#include <vector>

#include "core/competition/competition_registry.hpp"
#include "core/overlap/overlap_registry.hpp"

namespace phytobench::experiments::alsweis {

/// Parameters with this share of competition above ground, or of the asymmetric one, and one
/// species.
inline CompetitionParameters with_share(double p) {
  return {.above_share = p, .species = std::vector<CompetitionTraits>(1)};
}

struct FewPlants {
  std::vector<double> x, y, root, crown, stem, weakening;
  std::vector<SpeciesIndex> species;

  void add(double at_x, double root_radius, double crown_radius, SpeciesIndex kind = 0,
           double weakened = 0.0) {
    x.push_back(at_x);
    y.push_back(0.0);
    root.push_back(root_radius);
    crown.push_back(crown_radius);
    stem.push_back(0.1 * root_radius);
    weakening.push_back(weakened);
    species.push_back(kind);
  }

  /// phi of every plant on the open plane.
  std::vector<double> losses(std::string_view rule,
                             const CompetitionParameters& parameters = with_share(0.5)) const {
    PairSearch search(overlap_engine_named("all_pairs"), {});
    std::vector<double> loss(x.size());
    competition_rule_named(rule)
        .create(parameters)
        ->assess({.below = {x, y, root},
                  .above = {x, y, crown},
                  .stem_radius = stem,
                  .species = species,
                  .weakening = weakening},
                 {}, search, loss);
    return loss;
  }
};

/// Two plants whose roots and crowns reach equally far.
inline FewPlants two_plants_apart(double distance, double first_radius, double second_radius) {
  FewPlants plants;
  plants.add(0.0, first_radius, first_radius, 0);
  plants.add(distance, second_radius, second_radius, 0);
  return plants;
}

}  // namespace phytobench::experiments::alsweis
