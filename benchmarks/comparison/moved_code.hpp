// SPDX-License-Identifier: MIT
// A change anywhere moves code in memory, and a tight loop may run a tenth or a fifth faster or
// slower for that alone (Mytkowicz et al. 2009). Instruction counts tell this from a real change.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/instruction_gate.hpp"

namespace phytobench {

/// Names of what was found slower or faster: what is worth counting.
std::vector<std::string> names_to_count(const std::vector<ConcludedBenchmark>& concluded);

/// Takes such a verdict back, to inconclusive, where both sides execute the same instructions, and
/// otherwise adds their change to its reason. What could not be counted stays as it is.
void consider_instructions(std::vector<ConcludedBenchmark>& concluded,
                           const std::vector<CountedPair>& counted);

}  // namespace phytobench
