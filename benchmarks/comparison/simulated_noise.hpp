// SPDX-License-Identifier: MIT
// For tests: machines whose noise is known, and how often verdicts come out on them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "core/random/counter_stream.hpp"
#include "core/random/distributions.hpp"
#include "core/statistics/binomial_interval.hpp"

namespace phytobench {

inline constexpr int repetitions = 400;
// The interval's ends scatter by a tenth of its width at 1,000 resamples.
inline constexpr VerdictSettings quick{.resamples = 1000};

enum class NoiseLaw {
  lognormal,
  student,  ///< of two degrees of freedom: its variance is infinite
  spikes,   ///< lognormal, and every tenth process is disturbed ten times as much, only upwards
};

inline constexpr std::array every_law{NoiseLaw::lognormal, NoiseLaw::student, NoiseLaw::spikes};

/// How the time of a process scatters. Four of them make a block, whose log ratio scatters alike.
struct NoisyMachine {
  NoiseLaw law = NoiseLaw::lognormal;
  double noise = 0.03;  ///< scale of the law, of the logarithm
  double drift = 0.0;   ///< by how much of the first's time each takes longer than the last
};

inline double log_noise(const NoisyMachine& machine, UnitStream& stream) {
  if (machine.law == NoiseLaw::student) {
    const double u = std::max(stream.next_unit(), 0x1p-54);  // in (0, 1)
    return machine.noise * (2.0 * u - 1.0) / std::sqrt(2.0 * u * (1.0 - u));
  }
  double noise = random_normal(stream);
  if (machine.law == NoiseLaw::spikes && stream.next_unit() < 0.1)
    noise += 10.0 * random_exponential(stream);
  return machine.noise * noise;
}

/// The share of a verdict, with an interval that holds it 95 times in 100.
inline Estimate share_of(SpeedVerdict verdict, const std::vector<ConcludedBenchmark>& all) {
  const auto count = std::count_if(all.begin(), all.end(),
                                   [&](const auto& each) { return each.verdict == verdict; });
  return share_estimate(count, static_cast<std::int64_t>(all.size()));
}

/// The share of "slower" and "faster" together.
inline Estimate share_of_alarms(const std::vector<ConcludedBenchmark>& all) {
  const auto count = std::count_if(all.begin(), all.end(), [](const auto& each) {
    return each.verdict == SpeedVerdict::slower || each.verdict == SpeedVerdict::faster;
  });
  return share_estimate(count, static_cast<std::int64_t>(all.size()));
}

}  // namespace phytobench
