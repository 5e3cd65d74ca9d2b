// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor roots;
constinit const CompetitionRuleDescriptor roots{
    .name = "roots",
    .summary = "As above_below, where deeply rooted neighbours take up to twice as much.",
    .source = "[Alsweis] (7.3), read for the neighbour",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{.roots = true}>,
};

}  // namespace phytobench::competition_rules
