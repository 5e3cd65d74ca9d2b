// SPDX-License-Identifier: MIT
#include "core/competition/one_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

struct AsymmetricLaw {
  explicit AsymmetricLaw(const CompetitionParameters& parameters) : ties(parameters.ties) {}

  PairLosses operator()(const CompetingPlants& plants, const Discs& zone, const Ground&,
                        std::size_t i, std::size_t j, double overlap) const {
    const double first = lost_by_first(plants, zone, ties, i, j);
    return {first * overlap, (1.0 - first) * overlap};
  }

  TieRule ties;
};

}  // namespace

extern const CompetitionRuleDescriptor asymmetric;
constinit const CompetitionRuleDescriptor asymmetric{
    .name = "asymmetric",
    .summary = "The plant with the smaller zone loses all that both zones have in common.",
    .source = "[Alsweis] (4.3), read as a loss as in (5.2)",
    .create = one_zone_rule<AsymmetricLaw>,
};

}  // namespace phytobench::competition_rules
