// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/lsystem/derivation_case.hpp"

namespace phytobench {

/// A random tree of so many internodes whose first one has a signal; in each step those whose lower
/// neighbour has it take it over, one more: left contexts across branches, with a condition. After
/// n steps an internode holds its depth (the root's is 1) up to n + 1, and those above hold 0.
DerivationCase signal_derivation(std::size_t internodes, int steps);

}  // namespace phytobench
