// SPDX-License-Identifier: MIT
#include "core/statistics/false_discovery_rate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

constexpr double p_value_rounding = 1e-15;

Values random_p_values(std::uint64_t set, std::size_t count) {
  CounterStream stream(54, set);
  Values p_values(count);
  for (double& p : p_values) p = std::pow(stream.next_unit(), 3.0);
  return p_values;
}

// The worked example of the paper, sec. 4.1: 15 tests of thrombolysis after heart attacks, of which
// four are discoveries at 0.05; Bonferroni's inequality leaves three.
TEST(FalseDiscoveryAdjusted, MeetsTheExampleOf1995) {
  const Values p_values{0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                        0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.000};
  const Values adjusted = false_discovery_adjusted(p_values);
  EXPECT_EQ(std::count_if(adjusted.begin(), adjusted.end(), [](double p) { return p <= 0.05; }), 4);
  EXPECT_NEAR(adjusted[0], 0.0001 * 15.0, p_value_rounding);
  EXPECT_NEAR(adjusted[3], 0.0095 * 15.0 / 4.0, p_value_rounding);
  // The seventh has less to lose than the sixth, which therefore gets the same.
  EXPECT_NEAR(adjusted[5], 0.0298 * 15.0 / 7.0, p_value_rounding);
  EXPECT_EQ(adjusted[5], adjusted[6]);
  EXPECT_EQ(adjusted[14], 1.0);
}

TEST(FalseDiscoveryAdjusted, LeavesOneAlone) {
  EXPECT_EQ(false_discovery_adjusted({}), Values{});
  EXPECT_EQ(false_discovery_adjusted(Values{0.03}), Values{0.03});
}

TEST(FalseDiscoveryAdjusted, GivesEqualOnesTheSame) {
  EXPECT_EQ(false_discovery_adjusted(Values{0.02, 0.5, 0.02}), (Values{0.03, 0.5, 0.03}));
  EXPECT_EQ(false_discovery_adjusted(Values{0.0, 0.0}), (Values{0.0, 0.0}));
  EXPECT_EQ(false_discovery_adjusted(Values{1.0, 1.0}), (Values{1.0, 1.0}));
}

TEST(FalseDiscoveryAdjusted, RefusesWhatIsNoProbability) {
  EXPECT_THROW(false_discovery_adjusted(Values{0.5, -0.1}), ContractViolation);
  EXPECT_THROW(false_discovery_adjusted(Values{1.1}), ContractViolation);
  EXPECT_THROW(false_discovery_adjusted(Values{NAN}), ContractViolation);
}

TEST(FalseDiscoveryAdjustedLaw, LiesBetweenItselfAndBonferroni) {
  for (const std::size_t count : {1u, 2u, 7u, 30u}) {
    const Values p_values = random_p_values(count, count);
    const Values adjusted = false_discovery_adjusted(p_values);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_GE(adjusted[i], p_values[i]);
      EXPECT_LE(adjusted[i], std::min(1.0, p_values[i] * static_cast<double>(count)));
    }
  }
}

TEST(FalseDiscoveryAdjustedLaw, KeepsTheOrderOfTheTests) {
  const Values p_values = random_p_values(1, 25);
  const Values adjusted = false_discovery_adjusted(p_values);
  for (std::size_t i = 0; i < p_values.size(); ++i)
    for (std::size_t j = 0; j < p_values.size(); ++j)
      if (p_values[i] < p_values[j]) {
        EXPECT_LE(adjusted[i], adjusted[j]);
      }
}

TEST(FalseDiscoveryAdjustedLaw, FollowsAnyOrderOfTheValues) {
  const Values p_values = random_p_values(2, 25);
  const Values adjusted = false_discovery_adjusted(p_values);
  CounterStream stream(55, 0);
  const std::vector<std::size_t> order = random_order(p_values.size(), stream);
  Values shuffled;
  for (const std::size_t i : order) shuffled.push_back(p_values[i]);
  const Values of_shuffled = false_discovery_adjusted(shuffled);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(of_shuffled[i], adjusted[order[i]]);
}

// The rule of the paper as it is written: the discoveries at q are the k smallest, k being the
// largest rank with p_k <= q k / n.
TEST(FalseDiscoveryAdjustedOracle, DiscoversWhatTheStepUpRuleDoes) {
  for (std::uint64_t set = 0; set < 50; ++set) {
    Values p_values = random_p_values(100 + set, 20);
    std::sort(p_values.begin(), p_values.end());
    const double q = 0.1;
    std::ptrdiff_t discoveries = 0;
    for (std::ptrdiff_t k = 1; k <= 20; ++k)
      if (p_values[static_cast<std::size_t>(k - 1)] <= q * static_cast<double>(k) / 20.0)
        discoveries = k;
    const Values adjusted = false_discovery_adjusted(p_values);
    EXPECT_EQ(std::count_if(adjusted.begin(), adjusted.end(), [&](double p) { return p <= q; }),
              discoveries);
  }
}

}  // namespace
}  // namespace phytobench
