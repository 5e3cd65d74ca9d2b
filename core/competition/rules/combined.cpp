// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor combined;
constinit const CompetitionRuleDescriptor combined{
    .name = "combined",
    .summary = "All effects of chapters 5 and 7 at once.",
    .source = "[Alsweis] (5.6), (7.1) to (7.6)",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{
        .signs = true, .light = true, .roots = true, .illness = true, .stress = true}>,
};

}  // namespace phytobench::competition_rules
