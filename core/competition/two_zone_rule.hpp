// SPDX-License-Identifier: MIT
// Rules of [Alsweis] ch. 5 and 7: roots compete for nutrients, crowns for light, and a plant's loss
// is a weighted sum of both.
#pragma once

#include <memory>
#include <vector>

#include "core/competition/competition_rule.hpp"
#include "core/competition/pair_losses.hpp"

namespace phytobench {

/// What a rule looks at beside the overlaps.
struct TwoZoneEffects {
  bool signs = false;    ///< of species on species, (5.6)
  bool light = false;    ///< opacity of the larger crown, (7.1) and (7.2); else (5.3) and (5.4)
  bool roots = false;    ///< rank of the neighbour's roots, (7.3)
  bool illness = false;  ///< of the neighbour, (7.4)
  bool stress = false;   ///< of open ground, sec. 7.4
};

/// phi = p alpha + (1 - p) sigma ((5.5), (7.5)), each term as `effects` have it.
template <TwoZoneEffects effects>
class TwoZoneRule final : public CompetitionRule {
 public:
  explicit TwoZoneRule(const CompetitionParameters& parameters) : parameters_(parameters) {}

  void assess(const CompetingPlants& plants, const Ground& ground, PairSearch& search,
              std::span<double> loss) override {
    const double p = parameters_.above_share;
    sum_pair_losses(
        search, plants.below, ground, loss,
        [&](std::size_t i, std::size_t j, double overlap) { return below(plants, i, j, overlap); });
    divide_by_zone_area(plants.below, 1.0 - p, loss, search.threads());
    above_.resize(loss.size());
    sum_pair_losses(search, plants.above, ground, above_,
                    [&](std::size_t i, std::size_t j, double overlap) {
                      return above(plants, ground, i, j, overlap);
                    });
    divide_by_zone_area(plants.above, p, above_, search.threads());
    for (std::size_t i = 0; i < loss.size(); ++i) {
      loss[i] += above_[i];
      if constexpr (effects.stress)
        loss[i] += parameters_.species[plants.species[i]].open_ground_stress;
    }
  }

 private:
  /// What j takes from i and i from j, below ground.
  PairLosses below(const CompetingPlants& plants, std::size_t i, std::size_t j,
                   double overlap) const {
    PairLosses losses = equal_losses(overlap);
    const SpeciesIndex a = plants.species[i], b = plants.species[j];
    if constexpr (effects.roots) {
      losses.first *= 1.0 + parameters_.species[b].root_rank;
      losses.second *= 1.0 + parameters_.species[a].root_rank;
    }
    if (effects.illness && !plants.weakening.empty()) {
      losses.first *= 1.0 - plants.weakening[j];
      losses.second *= 1.0 - plants.weakening[i];
    }
    return with_signs(parameters_.influence_below, a, b, losses);
  }

  PairLosses above(const CompetingPlants& plants, const Ground& ground, std::size_t i,
                   std::size_t j, double overlap) const {
    const Discs& zone = plants.above;
    const SpeciesIndex a = plants.species[i], b = plants.species[j];
    const double r_i = zone.radius[i], r_j = zone.radius[j];
    const double distance = distance_of_pair(zone, ground, i, j, overlap);
    const int ring = zone_index(distance, std::min(r_i, r_j), std::max(r_i, r_j));
    double first = lost_by_first(plants, zone, parameters_.ties, i, j);
    double weight = ring_weight(ring);
    if constexpr (effects.light) {
      // Who wins keeps (1 + L/q) / 2 of the overlap, where L is the opacity of its own crown.
      const double opacity = parameters_.species[first < 0.5 ? a : b].crown_opacity;
      first = 0.5 + (first - 0.5) * opacity;
      weight = parameters_.light_constant / ring;
    }
    return with_signs(parameters_.influence_above, a, b,
                      (weight * overlap) * PairLosses{first, 1.0 - first});
  }

  PairLosses with_signs(const std::vector<Influence>& influence, SpeciesIndex a, SpeciesIndex b,
                        PairLosses losses) const {
    if constexpr (effects.signs) {
      if (influence.empty()) return losses;
      const std::size_t species = parameters_.species.size();
      losses.first *= static_cast<double>(influence[a * species + b]);
      losses.second *= static_cast<double>(influence[b * species + a]);
    }
    return losses;
  }

  CompetitionParameters parameters_;
  std::vector<double> above_;
};

template <TwoZoneEffects effects>
std::unique_ptr<CompetitionRule> two_zone_rule(const CompetitionParameters& parameters) {
  return std::make_unique<TwoZoneRule<effects>>(parameters);
}

}  // namespace phytobench
