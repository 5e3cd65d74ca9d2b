// SPDX-License-Identifier: MIT
// Verdicts on times that were measured one side after the other. Whatever the machine did between
// the two looks like a change, so the tolerance is generous, and a small change is never found:
// for that measure both sides in turns (conclude() of comparison.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/stored_result.hpp"

namespace phytobench {

struct UnpairedVerdictSettings {
  double tolerance = 0.10;        ///< a change of less does not matter; > 0
  double alpha = 0.05;            ///< of the test, over all benchmarks together
  double noise_factor = 1.0;      ///< a change must exceed so many times the noise floor
  int least_repetitions = 9;      ///< of each side; of fewer nothing is concluded
  int resamples = 10000;          ///< of the bootstrap
  std::uint64_t seed = 20190906;  ///< of the bootstrap; the same file gives the same verdict
};

/// A verdict for each benchmark of base, and for each that only `other` has, in the order of the
/// files. "slower" and "faster" take a ratio of medians whose 95 % interval lies beyond the
/// tolerance and beyond the noise floor, and a two-sided rank-sum test; "same" takes an
/// interval within the tolerance and a noise floor below it. `control` compares the odd repetitions
/// of base with the even ones. `blocks` is the smaller number of repetitions. Results of different
/// machines get no verdict. Throws NothingSelected where no benchmark is in both.
std::vector<ConcludedBenchmark> conclude_stored(const StoredResult& base, const StoredResult& other,
                                                const UnpairedVerdictSettings& settings = {});

/// Why numbers of the two machines say nothing about the builds, as one clause; empty if they do.
std::string difference_of_machines(const ResultMachine& base, const ResultMachine& other);

}  // namespace phytobench
