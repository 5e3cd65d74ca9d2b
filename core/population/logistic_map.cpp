// SPDX-License-Identifier: MIT
#include "core/population/logistic_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

void expect_bounded_orbits(const LogisticMap& map, const OrbitOptions& options) {
  PHYTOBENCH_EXPECT(map.fertility > 0.0 && map.fertility <= largest_bounded_fertility);
  PHYTOBENCH_EXPECT(map.mortality < 0.0 && options.start > 0.0 && options.start < 1.0);
}

double count_after(const LogisticMap& map, double count, std::size_t years) {
  for (std::size_t t = 0; t < years; ++t) count = map.next(count);
  return count;
}

double settled_count(const LogisticMap& map, const OrbitOptions& options) {
  return count_after(map, options.start * map.capacity(), options.transient);
}

/// How far the count 1/2 is from its place after 2^doublings years, for K = 1, and how fast that
/// changes with r.
struct Miss {
  double distance;
  double slope;
};

Miss miss_of_middle(double rate, std::size_t doublings) {
  double x = 0.5, dx = 0.0;
  for (std::size_t t = 0; t < (std::size_t{1} << doublings); ++t) {
    dx = x * (1.0 - x) + rate * (1.0 - 2.0 * x) * dx;
    x = rate * x * (1.0 - x);
  }
  return {x - 0.5, dx};
}

}  // namespace

LogisticMap LogisticMap::of_rate(double reproduction_rate, double capacity) {
  PHYTOBENCH_EXPECT(reproduction_rate >= 0.0 && capacity > 0.0);
  return {.fertility = reproduction_rate - 1.0, .mortality = -reproduction_rate / capacity};
}

std::vector<double> orbit(const LogisticMap& map, double start, std::size_t years) {
  std::vector<double> counts{start};
  counts.reserve(years + 1);
  for (std::size_t t = 0; t < years; ++t) counts.push_back(map.next(counts.back()));
  return counts;
}

double lyapunov_exponent(const LogisticMap& map, const OrbitOptions& options) {
  expect_bounded_orbits(map, options);
  PHYTOBENCH_EXPECT(options.years > 0);
  double count = settled_count(map, options), sum = 0.0;
  for (std::size_t t = 0; t < options.years; ++t) {
    sum += std::log(std::abs(map.multiplier(count)));
    count = map.next(count);
  }
  return sum / static_cast<double>(options.years);
}

std::optional<std::size_t> attractor_period(const LogisticMap& map, std::size_t largest,
                                            const OrbitOptions& options) {
  expect_bounded_orbits(map, options);
  PHYTOBENCH_EXPECT(largest > 0);
  const double tolerance = 1e-9 * map.capacity();
  const std::vector<double> counts = orbit(map, settled_count(map, options), 3 * largest);
  for (std::size_t period = 1; period <= largest; ++period) {
    bool returns = true;
    for (std::size_t t = 0; t + period < counts.size(); ++t)
      returns = returns && std::abs(counts[t + period] - counts[t]) <= tolerance;
    if (returns) return period;
  }
  return std::nullopt;
}

double superstable_fertility(std::size_t doublings) {
  PHYTOBENCH_EXPECT(doublings <= 12);
  constexpr double feigenbaum = 4.669201609102990;
  double rate = 2.0, next = 1.0 + std::sqrt(5.0);
  if (doublings == 0) return rate - 1.0;
  for (std::size_t k = 2; k <= doublings; ++k) {
    // Guess by the limit of the ratios, then Newton: the guess is within a few percent of the gap.
    const double guess = next + (next - rate) / feigenbaum;
    rate = next;
    next = guess;
    for (int i = 0; i < 8; ++i) {
      const Miss miss = miss_of_middle(next, k);
      next -= miss.distance / miss.slope;
    }
  }
  return next - 1.0;
}

}  // namespace phytobench
