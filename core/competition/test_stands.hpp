// SPDX-License-Identifier: MIT
// Stands of a few plants for tests of competition rules.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/competition/competition_registry.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::testing_stands {

inline CompetitionParameters with_exponent(double exponent, TieRule ties = TieRule::share) {
  CompetitionParameters parameters;
  parameters.asymmetry_exponent = exponent;
  parameters.ties = ties;
  return parameters;
}

struct TestStand {
  std::vector<double> x, y, below, above, stem, weakening;
  std::vector<SpeciesIndex> species;
  std::vector<std::uint64_t> id;
  Ground ground;

  void add(double px, double py, double root, double crown, SpeciesIndex kind = 0,
           double weak = 0.0) {
    x.push_back(px);
    y.push_back(py);
    below.push_back(root);
    above.push_back(crown);
    stem.push_back(0.05 * root);
    weakening.push_back(weak);
    species.push_back(kind);
    id.push_back(id.size());
  }
  std::size_t size() const { return x.size(); }

  CompetingPlants plants() const {
    return {.below = {x, y, below},
            .above = {x, y, above},
            .stem_radius = stem,
            .species = species,
            .weakening = weakening,
            .id = id};
  }

  TestStand permuted(const std::vector<std::size_t>& order) const {
    TestStand other;
    other.ground = ground;
    for (const std::size_t i : order) {
      other.add(x[i], y[i], below[i], above[i], species[i], weakening[i]);
      other.id.back() = id[i];
    }
    return other;
  }
};

inline std::vector<double> losses(std::string_view rule, const CompetitionParameters& parameters,
                                  const TestStand& stand, int threads = 1,
                                  std::string_view engine = "all_pairs") {
  PairSearch search(overlap_engine_named(engine), {.threads = threads});
  std::vector<double> loss(stand.size(), -7.0);
  competition_rule_named(rule)
      .create(parameters)
      ->assess(stand.plants(), stand.ground, search, loss);
  return loss;
}

/// Two species of which one is tall, some plants ill, many overlaps, on a torus or an open plane.
inline TestStand crowded_stand(std::size_t count, bool torus, std::uint64_t seed = 5) {
  TestStand stand;
  if (torus) stand.ground.torus = Rectangle{{-3.0, 2.0}, {17.0, 22.0}};
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double px = -3.0 + 20.0 * stream.next_unit(), py = 2.0 + 20.0 * stream.next_unit();
    const double root = 0.3 + 2.5 * stream.next_unit(), crown = 0.2 + 2.0 * stream.next_unit();
    const auto kind = static_cast<SpeciesIndex>(stream.next_unit() < 0.3 ? 1 : 0);
    stand.add(px, py, root, crown, kind, i % 5 == 0 ? stream.next_unit() : 0.0);
  }
  return stand;
}

/// Every effect is there, and differs between the two species.
inline CompetitionParameters two_species() {
  return {
      .above_share = 0.3,
      .asymmetry_exponent = 1.7,
      .light_constant = 1.2,
      .species = {{.crown_opacity = 0.2, .root_rank = 0.0, .open_ground_stress = 0.1},
                  {.crown_opacity = 0.9, .root_rank = 1.0}},
      .influence_above = {Influence::harms, Influence::none, Influence::helps, Influence::harms},
      .influence_below = {Influence::helps, Influence::harms, Influence::harms, Influence::none}};
}

}  // namespace phytobench::testing_stands
