// SPDX-License-Identifier: MIT
#include "core/competition/two_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

constexpr TwoZoneEffects effects{.signs = true, .stress = true};

/// (7.6) turns the sign of all roots; whoever names species says which of them help.
std::unique_ptr<CompetitionRule> create(const CompetitionParameters& parameters) {
  CompetitionParameters own = parameters;
  if (own.influence_below.empty())
    own.influence_below.assign(own.species.size() * own.species.size(), Influence::helps);
  return two_zone_rule<effects>(own);
}

}  // namespace

extern const CompetitionRuleDescriptor nurse;
constinit const CompetitionRuleDescriptor nurse{
    .name = "nurse",
    .summary =
        "Roots of the species that say so help against the stress of open ground; crowns harm.",
    .source = "[Alsweis] sec. 7.4, (7.6), for each pair of species",
    .uses_above = true,
    .create = create,
};

}  // namespace phytobench::competition_rules
