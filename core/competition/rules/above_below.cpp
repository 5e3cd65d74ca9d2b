// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor above_below;
constinit const CompetitionRuleDescriptor above_below{
    .name = "above_below",
    .summary =
        "Roots halve what they have in common, larger crowns take all of it, less in their two "
        "outer rings.",
    .source = "[Alsweis] (5.1) to (5.5)",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{}>,
};

}  // namespace phytobench::competition_rules
