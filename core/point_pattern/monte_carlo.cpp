// SPDX-License-Identifier: MIT
#include "core/point_pattern/monte_carlo.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

double rank_p_value(double observed, std::span<const double> simulated, Tail tail) {
  PHYTOBENCH_EXPECT(!std::isnan(observed));
  std::size_t above = 1, below = 1;
  for (const double value : simulated) {
    PHYTOBENCH_EXPECT(!std::isnan(value));
    above += value >= observed;
    below += value <= observed;
  }
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(simulated.size() + 1);
  };
  switch (tail) {
    case Tail::upper:
      return share(above);
    case Tail::lower:
      return share(below);
    case Tail::both:
      break;
  }
  return std::min(1.0, share(2 * std::min(above, below)));
}

std::vector<double> simulated_statistics(std::size_t count, const SimulatedStatistic& statistic,
                                         int threads) {
  std::vector<double> values(count);
  for_tasks(count, threads, [&](std::size_t index) { values[index] = statistic(index); });
  return values;
}

double monte_carlo_p_value(double observed, std::size_t simulations,
                           const SimulatedStatistic& statistic, Tail tail, int threads) {
  return rank_p_value(observed, simulated_statistics(simulations, statistic, threads), tail);
}

}  // namespace phytobench
