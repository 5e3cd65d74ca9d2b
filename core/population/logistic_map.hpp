// SPDX-License-Identifier: MIT
// A population without plants: one count per year, and what becomes of it in the long run.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace phytobench {

/// The discrete logistic equation N(t+1) = N + alpha N + beta N^2, [Alsweis] (2.11).
struct LogisticMap {
  double fertility = 0.0;  ///< alpha: yearly growth of a sparse population, at least -1
  double mortality = 0.0;  ///< beta: what each plant takes from that; per plant, at most 0

  /// The same as N(t+1) = r N (1 - N / K), [Alsweis] (2.9): r at least 0, K above 0;
  /// ContractViolation otherwise.
  static LogisticMap of_rate(double reproduction_rate, double capacity);

  /// The count of the next year. Below 0 from a count above capacity().
  double next(double count) const { return count + count * (fertility + mortality * count); }
  /// Derivative of next(): by what a small difference is multiplied.
  double multiplier(double count) const { return 1.0 + fertility + 2.0 * mortality * count; }

  double reproduction_rate() const { return 1.0 + fertility; }  ///< r
  /// K: counts above it leave nothing. Neither a count the map can reach for r < 4, nor the
  /// equilibrium. Infinite without mortality.
  double capacity() const { return reproduction_rate() / std::abs(mortality); }
  /// N_eq = -alpha / beta: stays as it is; attracts all counts in (0, K) if 0 < alpha <= 2.
  double equilibrium() const { return -fertility / mortality; }
  /// multiplier() at the equilibrium.
  double equilibrium_multiplier() const { return 1.0 - fertility; }
  /// The largest count of any next year: r K / 4, from a count of K / 2.
  double largest_next() const { return 0.25 * reproduction_rate() * capacity(); }

  friend constexpr bool operator==(const LogisticMap&, const LogisticMap&) = default;
};

/// Fertilities at which the long run changes; it depends on nothing else. Populations die out up to
/// 0, settle up to 2, swing between two counts up to sqrt 6, then between 4, 8, 16, ... From 2.57
/// on most orbits are chaotic, with windows of periods between (three from sqrt 8 on); beyond 3
/// they leave every bound.
inline constexpr double fertility_of_two_counts = 2.0;
inline constexpr double fertility_of_four_counts = 2.449489742783178;    // sqrt 6
inline constexpr double fertility_of_chaos = 2.569945671870945;          // all doublings done
inline constexpr double fertility_of_three_counts = 2.8284271247461903;  // sqrt 8
inline constexpr double largest_bounded_fertility = 3.0;

/// Which part of an orbit is looked at. Where it starts does not matter but for a set of counts of
/// measure 0, to which 0, the equilibrium and what leads there belong.
struct OrbitOptions {
  /// Share of the capacity, in (0, 1). No round number: at alpha = 7/3 all years from 0.3 on are
  /// the unstable equilibrium.
  double start = 0.31415926;
  std::size_t transient = 20000;  ///< years that are left out
  std::size_t years = 65536;      ///< years that count; a multiple of the period is exact
};

/// Counts of the years 0 ... years.
std::vector<double> orbit(const LogisticMap& map, double start, std::size_t years);

/// The mean logarithm of the multiplier along an orbit: below 0 small differences vanish, above 0
/// they grow (chaos). -infinity where the orbit meets the multiplier 0, as it does at alpha = 1.
/// Fertility in (0, 3], mortality below 0; ContractViolation otherwise.
double lyapunov_exponent(const LogisticMap& map, const OrbitOptions& options = {});

/// The number of counts between which a population swings in the long run: the least p up to
/// `largest` for which all counts of the last years return after p years, to 1e-9 of the capacity.
/// Nothing if there is none: chaos, or a longer period. Just at a threshold orbits settle too
/// slowly for any transient. Domain as lyapunov_exponent().
std::optional<std::size_t> attractor_period(const LogisticMap& map, std::size_t largest = 64,
                                            const OrbitOptions& options = {});

/// The fertility at which the count K / 2, whose multiplier is 0, lies on a cycle of 2^doublings
/// years: one for each number of doublings, between the thresholds. They close in on
/// fertility_of_chaos by Feigenbaum's 4.669 each. Up to 12 doublings; ContractViolation otherwise.
double superstable_fertility(std::size_t doublings);

}  // namespace phytobench
