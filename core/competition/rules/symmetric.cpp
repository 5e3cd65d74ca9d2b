// SPDX-License-Identifier: MIT
#include "core/competition/one_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

struct SymmetricLaw {
  explicit SymmetricLaw(const CompetitionParameters&) {}

  PairLosses operator()(const CompetingPlants&, const Discs&, const Ground&, std::size_t,
                        std::size_t, double overlap) const {
    return equal_losses(overlap);
  }
};

}  // namespace

extern const CompetitionRuleDescriptor symmetric;
constinit const CompetitionRuleDescriptor symmetric{
    .name = "symmetric",
    .summary = "Both plants lose half of what their zones have in common.",
    .source = "[Alsweis] (4.2), (5.1)",
    .create = one_zone_rule<SymmetricLaw>,
};

}  // namespace phytobench::competition_rules
