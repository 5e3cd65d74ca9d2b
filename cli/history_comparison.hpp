// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands.hpp"

namespace phytobench::cli {

/// What changed from the first run that options.names names to the second; without a second to the
/// latest that has a value in common with the first. A name is that of a baseline or a run's
/// number. Of options.quantity alone if it is given; InputError naming what there is where the
/// first run lacks it. Never fails because of a change: a history says what happened, gates judge.
/// Throws NothingSelected where there is nothing to compare.
int compare_history(const HistoryOptions& options);

}  // namespace phytobench::cli
