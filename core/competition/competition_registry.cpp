// SPDX-License-Identifier: MIT
#include "core/competition/competition_registry.hpp"

#include <array>

#include "core/contract/registered.hpp"

// A test may add a second list to prove that a line and a file are all a rule needs.
#ifndef PHYTOBENCH_EXTRA_COMPETITION_RULES
#define PHYTOBENCH_EXTRA_COMPETITION_RULES "core/competition/no_extra_competition_rules.def"
#endif

namespace phytobench {

namespace competition_rules {
#define RULE(name, dependency) extern const CompetitionRuleDescriptor name;
#include "core/competition/competition_rules.def"
#include PHYTOBENCH_EXTRA_COMPETITION_RULES
#undef RULE
}  // namespace competition_rules

namespace {

constexpr auto table = std::to_array<const CompetitionRuleDescriptor*>({
#define RULE(name, dependency) &competition_rules::name,
#include "core/competition/competition_rules.def"
#include PHYTOBENCH_EXTRA_COMPETITION_RULES
#undef RULE
});

}  // namespace

std::span<const CompetitionRuleDescriptor* const> all_competition_rules() {
  return table;
}

std::string known_competition_rule_names() {
  return registered_names(all_competition_rules());
}

const CompetitionRuleDescriptor& competition_rule_named(std::string_view name) {
  return registered_as(name, "rule", all_competition_rules());
}

}  // namespace phytobench
