// SPDX-License-Identifier: MIT
#include "core/point_pattern/monte_carlo.hpp"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/statistics/chi_square.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Values = std::vector<double>;

TEST(RankPValue, CountsTheObservedValueAmongAll) {
  const Values simulated{1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(rank_p_value(5.0, simulated, Tail::upper), 0.2);
  EXPECT_EQ(rank_p_value(5.0, simulated, Tail::lower), 1.0);
  EXPECT_EQ(rank_p_value(5.0, simulated, Tail::both), 0.4);
  EXPECT_EQ(rank_p_value(0.0, simulated, Tail::both), 0.4);
  EXPECT_EQ(rank_p_value(1.5, simulated, Tail::lower), 0.4);
  EXPECT_EQ(rank_p_value(2.5, simulated, Tail::both), 1.0);
  EXPECT_EQ(rank_p_value(0.0, {}, Tail::both), 1.0);
}

TEST(RankPValue, LetsTiesCountAgainstSignificance) {
  const Values simulated{1.0, 3.0, 3.0, 3.0};
  EXPECT_EQ(rank_p_value(3.0, simulated, Tail::upper), 0.8);
  EXPECT_EQ(rank_p_value(3.0, simulated, Tail::lower), 1.0);
  EXPECT_EQ(rank_p_value(7.0, Values(19, 7.0), Tail::both), 1.0);
}

TEST(RankPValue, TakesInfinityAndRefusesNaN) {
  EXPECT_EQ(rank_p_value(infinity, Values{1.0, infinity, 2.0}, Tail::upper), 0.5);
  EXPECT_THROW(rank_p_value(NAN, Values{1.0}, Tail::upper), ContractViolation);
  EXPECT_THROW(rank_p_value(1.0, Values{1.0, NAN}, Tail::both), ContractViolation);
}

// Whichever of n + 1 different values is the observed one: each p-value k / (n + 1) comes up once.
TEST(RankPValueLaw, IsUniformOverExchangeableValues) {
  for (std::size_t observed = 0; observed < 20; ++observed) {
    Values others(20);
    std::iota(others.begin(), others.end(), 0.0);
    const double value = others[observed];
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(observed));
    const auto position = static_cast<double>(observed);
    EXPECT_EQ(rank_p_value(value, others, Tail::upper), (20.0 - position) / 20.0);
    EXPECT_EQ(rank_p_value(value, others, Tail::lower), (position + 1.0) / 20.0);
    EXPECT_EQ(rank_p_value(value, others, Tail::both),
              2.0 * std::min(20.0 - position, position + 1.0) / 20.0);
  }
}

TEST(RankPValueLaw, KeepsTheLevelWithTies) {
  for (const int kinds : {1, 2, 3, 10}) {
    int alarms = 0;
    constexpr int runs = 4000;
    for (std::uint64_t run = 0; run < runs; ++run) {
      CounterStream stream(31, run);
      Values values;
      for (int i = 0; i < 20; ++i) values.push_back(std::floor(stream.next_unit() * kinds));
      alarms += rank_p_value(values[0], std::span(values).subspan(1), Tail::upper) <= 0.1;
    }
    EXPECT_LE(alarms, 0.1 * runs + chance * std::sqrt(0.09 * runs)) << kinds << " kinds";
  }
}

double mean_nearest_distance(const Points& points, const Window& window) {
  const Values distances = nearest_distances(points, window);
  return std::accumulate(distances.begin(), distances.end(), 0.0) /
         static_cast<double>(distances.size());
}

double p_value_of(const Points& points, const Window& window, std::uint64_t seed, Tail tail) {
  return monte_carlo_p_value(
      mean_nearest_distance(points, window), 39,
      [&](std::uint64_t index) {
        return mean_nearest_distance(random_pattern(window, points.size(), seed, index), window);
      },
      tail);
}

TEST(MonteCarloLaw, PValuesOfRandomPatternsAreUniform) {
  const Window window = Window::rectangle(unit_square);
  std::array<std::int64_t, 40> counts{};
  Values spread;
  for (std::uint64_t run = 0; run < 1000; ++run) {
    const Points points = random_points(window, 50, run);
    const double p_value = p_value_of(points, window, 1000 + run, Tail::upper);
    ++counts[static_cast<std::size_t>(std::lround(40.0 * p_value)) - 1];
    // Uniform on [0, 1] if the p-value is uniform on its 40 steps.
    spread.push_back(p_value - random_unit(32, 0, run) / 40.0);
  }
  EXPECT_GT(uniformity_p_value(counts), 1e-4);
  EXPECT_GT(kolmogorov_uniformity_p_value(spread), 1e-4);
}

TEST(MonteCarlo, SeesClustersAndLattices) {
  const Window window = Window::rectangle(lattice_box(7, 7));
  EXPECT_EQ(p_value_of(square_lattice(7, 7), window, 1, Tail::upper), 1.0 / 40.0);
  int found = 0;
  for (std::uint64_t set = 0; set < 20; ++set)
    found += p_value_of(clustered_points(window, 50, 0.5, set), window, set, Tail::lower) <= 0.05;
  EXPECT_GE(found, 19);
}

TEST(MonteCarloLaw, ThreadsDoNotMatter) {
  const auto statistic = [](std::uint64_t index) {
    return mean_nearest_distance(random_pattern(l_shape(), 100, 5, index), l_shape());
  };
  EXPECT_EQ(simulated_statistics(99, statistic, 4), simulated_statistics(99, statistic));
  EXPECT_EQ(simulated_statistics(3, statistic)[2], statistic(2));
}

}  // namespace
}  // namespace phytobench
