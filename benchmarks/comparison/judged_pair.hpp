// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/timed_side.hpp"

namespace phytobench {

/// Benchmarks before anything is timed.
struct JudgedPair {
  std::vector<MeasuredBenchmark> benchmarks;   ///< with the objection to those that get no time
  std::map<std::string, std::string> answers;  ///< of the others by name: the digest both gave
};

/// Runs every benchmark once on each side that has it and lets its oracle judge. A wrong answer is
/// an objection; it is no comparison of the same work if only one side has the benchmark, if the
/// inputs differ, or if the answers do although the oracles have nothing against either.
JudgedPair judge_pair(TimedSide& base, TimedSide& other, const std::vector<std::string>& names);

}  // namespace phytobench
