// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace phytobench {

/// Which values of a statistic speak against the null model.
enum class Tail { upper, lower, both };

/// The share of all 1 + n values, the observed one among them, that are at least as extreme as it:
/// (1 + #{simulated >= observed}) / (1 + n) for the upper tail (Barnard 1963, Besag and Diggle
/// 1977); for both, twice the smaller one-sided value, at most 1. If the observed value is a
/// simulation's peer, P(p <= a) <= a for every a, and = a where a (1 + n) is a whole number (for
/// both tails: an even one) and values do not tie. Ties count against significance, so the level is
/// kept whatever the statistic, at the price of power where it has few values. Without simulations
/// it is 1. Infinite values are fine; ContractViolation for NaN.
double rank_p_value(double observed, std::span<const double> simulated, Tail tail);

/// A statistic of the simulation with this index. It must depend on the index alone (draw from
/// CounterStream(seed, index)) and may run on several threads at once.
using SimulatedStatistic = std::function<double(std::uint64_t index)>;

/// The statistic of simulations 0 ... count - 1; the same for any number of threads.
std::vector<double> simulated_statistics(std::size_t count, const SimulatedStatistic& statistic,
                                         int threads = 1);

/// rank_p_value() of the observed value among that many simulations.
double monte_carlo_p_value(double observed, std::size_t simulations,
                           const SimulatedStatistic& statistic, Tail tail, int threads = 1);

}  // namespace phytobench
