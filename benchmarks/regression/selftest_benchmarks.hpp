// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "benchmarks/regression/watched_benchmarks.hpp"

namespace phytobench {

/// What an instrument must be tried on before it is believed, and what must become of it:
/// - "selftest/steady": fixed work of about 0.2 ms with the right answer; to be timed.
/// - "selftest/wrong-answer": an engine that breaks ties upwards; to be refused by its oracle.
/// - "selftest/measures-nothing": a run does nothing; no time of it means anything.
/// - "selftest/forgets-work": right at first, then half of the work and another answer; to be
///   refused while it is sampled.
/// - "selftest/stops-working": right and busy until its answer was looked at, then a run does
/// nothing
///   and leaves the right answer where it is; to be refused while it is sampled.
std::vector<WatchedBenchmark> selftest_benchmarks();

}  // namespace phytobench
