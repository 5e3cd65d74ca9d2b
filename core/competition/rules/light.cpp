// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor light;
constinit const CompetitionRuleDescriptor light{
    .name = "light",
    .summary =
        "Crowns let light through by their opacity, weighted by ring; roots halve what they have "
        "in common.",
    .source = "[Alsweis] (7.1), (7.2), (7.5), corrected",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{.light = true}>,
};

}  // namespace phytobench::competition_rules
