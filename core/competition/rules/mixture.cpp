// SPDX-License-Identifier: MIT
#include "core/competition/one_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

struct MixedLaw {
  explicit MixedLaw(const CompetitionParameters& parameters)
      : p(parameters.above_share), ties(parameters.ties) {}

  PairLosses operator()(const CompetingPlants& plants, const Discs& zone, const Ground&,
                        std::size_t i, std::size_t j, double overlap) const {
    const double first = lost_by_first(plants, zone, ties, i, j);
    return p * PairLosses{first * overlap, (1.0 - first) * overlap} +
           (1.0 - p) * equal_losses(overlap);
  }

  double p;
  TieRule ties;
};

}  // namespace

extern const CompetitionRuleDescriptor mixture;
constinit const CompetitionRuleDescriptor mixture{
    .name = "mixture",
    .summary = "A share p of the overlap goes to the larger plant, the rest is halved.",
    .source = "[Alsweis] (4.4)",
    .create = one_zone_rule<MixedLaw>,
};

}  // namespace phytobench::competition_rules
