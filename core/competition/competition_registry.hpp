// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/competition/competition_rule.hpp"

namespace phytobench {

/// Every rule of competition_rules.def in that order, whether built or not.
std::span<const CompetitionRuleDescriptor* const> all_competition_rules();

/// The built rule of that name. Throws InputError naming the known ones, or the missing package.
const CompetitionRuleDescriptor& competition_rule_named(std::string_view name);

/// "none, symmetric, ..." for messages.
std::string known_competition_rule_names();

}  // namespace phytobench
