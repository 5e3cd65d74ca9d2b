// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor influence_signs;
constinit const CompetitionRuleDescriptor influence_signs{
    .name = "influence_signs",
    .summary =
        "As above_below, where every species may harm, help or leave alone every other, above and "
        "below ground.",
    .source = "[Alsweis] (5.6), table 5.1",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{.signs = true}>,
};

}  // namespace phytobench::competition_rules
