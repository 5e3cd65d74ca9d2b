// SPDX-License-Identifier: MIT
#include "core/competition/competition_registry.hpp"

#include <array>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

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
  std::string names;
  for (const CompetitionRuleDescriptor* rule : table) {
    if (!names.empty()) names += ", ";
    names += rule->name;
  }
  return names;
}

const CompetitionRuleDescriptor& competition_rule_named(std::string_view name) {
  std::vector<std::string> known;
  for (const CompetitionRuleDescriptor* rule : table) {
    known.emplace_back(rule->name);
    if (rule->name != name) continue;
    if (rule->built()) return *rule;
    throw InputError("rule '" + std::string(name) +
                     "' is not built: " + std::string(rule->missing_package) +
                     " was not found, or left out, when phytobench was configured; install it and "
                     "build again");
  }
  throw InputError("unknown rule '" + std::string(name) + "'" + did_you_mean(name, known) +
                   "; known: " + known_competition_rule_names());
}

}  // namespace phytobench
