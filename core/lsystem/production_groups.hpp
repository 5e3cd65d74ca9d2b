// SPDX-License-Identifier: MIT
#pragma once

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// Gives the productions of equal predecessor, contexts and condition that have probabilities one
/// number, others their own. Throws InputError if a production could never be used because one
/// before it takes all its modules, if a group's probabilities do not add up to 1 within 1e-9, and
/// if a context names a symbol that contexts do not see. `system.source` names the text.
void number_groups(LSystem& system);

}  // namespace phytobench
