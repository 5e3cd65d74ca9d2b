// SPDX-License-Identifier: MIT
// The same questions need to be answered only once, however many engines are asked them.
#pragma once

#include <memory>

#include "benchmarks/nearest_node/growth_judge.hpp"

namespace phytobench {

/// Gives the answers of another judge and keeps them: a growth that asks the same questions in the
/// same order (every node compared, bit for bit but for the sign of zero) is answered from memory.
/// From the first other question on the other judge answers itself, after it has been asked
/// everything that came before. Keeps 48 bytes per node in each call and 8 per point whose node
/// has changed: some 200 MB for a tree of a million points, ten times as much for ten million.
std::unique_ptr<GrowthJudge> make_remembering_judge(std::unique_ptr<GrowthJudge> judge);

}  // namespace phytobench
