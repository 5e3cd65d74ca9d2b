// SPDX-License-Identifier: MIT
// Rules of [Alsweis] ch. 4: one zone around each plant, and a law of two plants.
#pragma once

#include <memory>

#include "core/competition/competition_rule.hpp"
#include "core/competition/pair_losses.hpp"

namespace phytobench {

/// `Law` is made from the parameters; its call (plants, zone, ground, i, j, overlap) gives
/// PairLosses.
template <class Law>
class OneZoneRule final : public CompetitionRule {
 public:
  explicit OneZoneRule(const CompetitionParameters& parameters) : law_(parameters) {}

  void assess(const CompetingPlants& plants, const Ground& ground, PairSearch& search,
              std::span<double> loss) override {
    const Discs& zone = plants.below;
    sum_pair_losses(search, zone, ground, loss, [&](std::size_t i, std::size_t j, double overlap) {
      return law_(plants, zone, ground, i, j, overlap);
    });
    divide_by_zone_area(zone, 1.0, loss, search.threads());
  }

 private:
  Law law_;
};

template <class Law>
std::unique_ptr<CompetitionRule> one_zone_rule(const CompetitionParameters& parameters) {
  return std::make_unique<OneZoneRule<Law>>(parameters);
}

}  // namespace phytobench
