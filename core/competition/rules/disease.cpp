// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

extern const CompetitionRuleDescriptor disease;
constinit const CompetitionRuleDescriptor disease{
    .name = "disease",
    .summary = "As above_below, where ill plants take less and less below ground.",
    .source = "[Alsweis] (7.4), corrected",
    .uses_above = true,
    .create = two_zone_rule<TwoZoneEffects{.illness = true}>,
};

}  // namespace phytobench::competition_rules
