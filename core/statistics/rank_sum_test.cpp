// SPDX-License-Identifier: MIT
#include "core/statistics/rank_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

constexpr double rank_rounding = 1e-13;  // of sums of some thousand counts

/// Pairs in which the first sample's value is the larger, ties half.
double won_pairs(const Values& first, const Values& second) {
  double pairs = 0.0;
  for (const double a : first)
    for (const double b : second) pairs += a > b ? 1.0 : a == b ? 0.5 : 0.0;
  return pairs;
}

/// By counting over all splits of the values into samples of these sizes.
RankSumTest by_all_splits(const Values& first, const Values& second) {
  Values all = first;
  all.insert(all.end(), second.begin(), second.end());
  const double observed = won_pairs(first, second);
  int as_large = 0, as_small = 0, splits = 0;
  for (unsigned split = 0; split < 1u << all.size(); ++split) {
    if (static_cast<std::size_t>(std::popcount(split)) != first.size()) continue;
    Values chosen, others;
    for (std::size_t i = 0; i < all.size(); ++i)
      ((split >> i & 1u) != 0 ? chosen : others).push_back(all[i]);
    const double u = won_pairs(chosen, others);
    ++splits;
    as_large += u >= observed;
    as_small += u <= observed;
  }
  return {.u = observed,
          .p_greater = static_cast<double>(as_large) / splits,
          .p_less = static_cast<double>(as_small) / splits};
}

Values uniform_values(std::uint64_t set, std::size_t count, double shift) {
  CounterStream stream(53, set);
  Values values(count);
  for (double& value : values) value = stream.next_unit() + shift;
  return values;
}

Values rounded(Values values) {
  for (double& value : values) value = std::round(5.0 * value);
  return values;
}

/// Samples without ties whose u is the given one.
std::pair<Values, Values> with_u(int first_size, int second_size, int u) {
  Values first, second;
  for (int i = 0; i < second_size; ++i) second.push_back(i);
  // A value just below the k-th of the others wins k pairs; later ones lie a little lower.
  for (int i = 0; i < first_size; ++i) {
    const int won = std::min(u, second_size);
    u -= won;
    first.push_back(won - 0.5 - 0.001 * i);
  }
  return {first, second};
}

TEST(RankSumTest, IsTheOneByHand) {
  // 2 of 5 can be chosen in 10 ways; only one other than this has a u of 1 or less.
  const RankSumTest test = rank_sum_test(Values{1, 3}, Values{2, 4, 5});
  EXPECT_EQ(test.u, 1.0);
  EXPECT_EQ(test.p_less, 2.0 / 10.0);
  EXPECT_EQ(test.p_greater, 9.0 / 10.0);
  EXPECT_EQ(test.p_two_sided, 4.0 / 10.0);
}

// Hollander and Wolfe 1973, Nonparametric Statistical Methods, p. 69: permeability of the human
// chorioamnion; R prints W = 35, p = 0.1272.
TEST(RankSumTest, OfPermeabilityIsTheKnownOne) {
  const RankSumTest test =
      rank_sum_test(Values{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46},
                    Values{1.15, 0.88, 0.90, 0.74, 1.21});
  EXPECT_EQ(test.u, 35.0);
  EXPECT_EQ(test.p_greater, 382.0 / 3003.0);
}

// The largest u that are significant at 0.05, 0.025, 0.01 and 0.005 on one side, as textbooks print
// them.
TEST(RankSumTest, MeetsTheTableOfCriticalValues) {
  struct Row {
    int first, second;
    std::vector<int> critical;
  };
  const Values levels{0.05, 0.025, 0.01, 0.005};
  for (const Row& row :
       {Row{5, 5, {4, 2, 1, 0}}, Row{8, 8, {15, 13, 9, 7}}, Row{5, 10, {11, 8, 6, 4}},
        Row{10, 10, {27, 23, 19, 16}}, Row{12, 9, {30, 26, 21, 18}}})
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const auto [first, second] = with_u(row.first, row.second, row.critical[i]);
      const auto [more, same] = with_u(row.first, row.second, row.critical[i] + 1);
      EXPECT_EQ(rank_sum_test(first, second).u, row.critical[i]);
      EXPECT_LE(rank_sum_test(first, second).p_less, levels[i]) << row.first;
      EXPECT_GT(rank_sum_test(more, same).p_less, levels[i]) << row.first;
    }
}

TEST(RankSumTest, OfEqualValuesSaysNothing) {
  for (const std::size_t count : {1u, 5u, 50u}) {
    const RankSumTest test = rank_sum_test(Values(count, 2.0), Values(count + 1, 2.0));
    EXPECT_EQ(test.p_greater, 1.0);
    EXPECT_EQ(test.p_less, 1.0);
    EXPECT_EQ(test.p_two_sided, 1.0);
  }
}

// The next term of the law's expansion, fourth cumulant / 24, is below 0.0015 at 31 and 31 values;
// a continuity correction of half a pair where ties have made the steps smaller adds as much.
TEST(RankSumTest, NormalLawMeetsTheExactOneWhereItTakesOver) {
  for (std::uint64_t set = 0; set < 10; ++set) {
    Values first = uniform_values(2 * set, 31, 0.02 * static_cast<double>(set));
    Values second = uniform_values(2 * set + 1, 31, 0.0);
    if (set % 2 == 1) first = rounded(first), second = rounded(second);
    const RankSumTest exact = rank_sum_test(first, second, {.largest_exact = 100});
    const RankSumTest normal = rank_sum_test(first, second, {.largest_exact = 0});
    EXPECT_NE(exact.p_greater, normal.p_greater);
    EXPECT_NEAR(exact.p_greater, normal.p_greater, 0.003);
    EXPECT_NEAR(exact.p_less, normal.p_less, 0.003);
  }
}

TEST(RankSumTest, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(rank_sum_test({}, Values{1}), ContractViolation);
  EXPECT_THROW(rank_sum_test(Values{1}, {}), ContractViolation);
  EXPECT_THROW(rank_sum_test(Values{1}, Values{NAN}), ContractViolation);
}

TEST(RankSumTestOracle, AgreesWithAllSplits) {
  for (std::size_t first_size = 1; first_size <= 6; ++first_size)
    for (std::size_t second_size = 1; second_size <= 5; ++second_size)
      for (std::uint64_t set = 0; set < 4; ++set) {
        const std::uint64_t place = 1000 + 100 * first_size + 10 * second_size + set;
        Values first = uniform_values(2 * place, first_size, 0.1);
        Values second = uniform_values(2 * place + 1, second_size, 0.0);
        if (set % 2 == 1) first = rounded(first), second = rounded(second);
        const RankSumTest test = rank_sum_test(first, second);
        const RankSumTest expected = by_all_splits(first, second);
        EXPECT_EQ(test.u, expected.u);
        EXPECT_EQ(test.p_greater, expected.p_greater);
        EXPECT_EQ(test.p_less, expected.p_less);
      }
}

TEST(RankSumTestLaw, SwappedSamplesSwapTheSides) {
  for (const std::size_t count : {1u, 6u, 30u, 31u, 80u}) {
    const Values first = uniform_values(count, count, 0.1);
    const Values second = uniform_values(count + 500, count + 3, 0.0);
    const RankSumTest test = rank_sum_test(first, second);
    const RankSumTest mirrored = rank_sum_test(second, first);
    EXPECT_EQ(test.u + mirrored.u, static_cast<double>(count * (count + 3)));
    EXPECT_NEAR(test.p_greater, mirrored.p_less, rank_rounding);
    EXPECT_NEAR(test.p_less, mirrored.p_greater, rank_rounding);
  }
}

TEST(RankSumTestLaw, FollowsAnyRisingScale) {
  Values first = uniform_values(7, 12, 0.1), second = uniform_values(8, 9, 0.0);
  const RankSumTest test = rank_sum_test(first, second);
  for (double& value : first) value = std::exp(value);
  for (double& value : second) value = std::exp(value);
  EXPECT_EQ(rank_sum_test(first, second).p_greater, test.p_greater);
}

}  // namespace
}  // namespace phytobench
