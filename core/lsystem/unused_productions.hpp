// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// A line "name:line:column: p2 is never used: why; what to do" for each production that replaces
/// nothing in any step: whose predecessor or context comes neither in the axiom nor from it, and
/// whose context holds only where that of an earlier production without condition holds, too. What
/// conditions say is not looked at. (Productions of the same contexts are refused when they are
/// read.)
std::vector<std::string> unused_productions(const LSystem& system);

}  // namespace phytobench
