// SPDX-License-Identifier: MIT
// Plants of which only the zones matter, and what rules say they lose.
#pragma once

#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/competition/competition_registry.hpp"
#include "core/overlap/overlap_registry.hpp"

namespace phytobench::experiments::alsweis {

/// The exponent of a sharing law at which the largest plant has all.
inline constexpr double winner_takes_all = std::numeric_limits<double>::infinity();

struct ZoneStand {
  std::vector<double> x, y, radius;
  Ground ground = {};

  void add(double at_x, double at_y, double zone_radius) {
    x.push_back(at_x);
    y.push_back(at_y);
    radius.push_back(zone_radius);
  }
  std::size_t size() const { return x.size(); }
  Discs zones() const { return {x, y, radius}; }
  double area(std::size_t i) const { return std::numbers::pi * radius[i] * radius[i]; }
  /// Stems are a tenth of their zones.
  std::vector<double> stems() const {
    std::vector<double> stem = radius;
    for (double& r : stem) r *= 0.1;
    return stem;
  }

  /// Share of its zone that each plant loses; by size^exponent where the rule knows one.
  std::vector<double> losses(std::string_view rule, double exponent = 0.0, int threads = 1) const {
    const CompetitionParameters parameters{.asymmetry_exponent = exponent,
                                           .species = std::vector<CompetitionTraits>(1)};
    PairSearch search(overlap_engine_named("layered_grid"), {.threads = threads});
    const std::vector<double> stem = stems();
    const std::vector<SpeciesIndex> species(size(), 0);
    std::vector<double> loss(size());
    competition_rule_named(rule)
        .create(parameters)
        ->assess({.below = zones(), .above = zones(), .stem_radius = stem, .species = species},
                 ground, search, loss);
    return loss;
  }
};

/// Five plants, lengths in metres, some of whose ground is covered two, three and four times. The
/// fifth stands wholly within the first two, and meets the third.
inline ZoneStand five_plants() {
  ZoneStand stand;
  stand.add(3.017, 2.931, 2.0);
  stand.add(4.983, 3.409, 1.6);
  stand.add(4.121, 4.887, 1.3);
  stand.add(1.213, 4.398, 1.1);
  stand.add(3.893, 3.571, 0.4);
  return stand;
}

/// Both ends of the family of sharing laws.
struct Division {
  const char* name;
  double exponent;
};
inline constexpr Division divisions[] = {{"equal", 0.0}, {"winner", winner_takes_all}};

}  // namespace phytobench::experiments::alsweis
