// SPDX-License-Identifier: MIT
#include "core/statistics/signed_rank.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

constexpr double sign_rounding = 1e-13;  // of sums of up to some thousand probabilities

/// By counting over all sign patterns, with ranks counted pair by pair.
SignedRankTest by_all_patterns(const Values& differences) {
  Values ranks;
  double observed = 0.0;
  for (const double difference : differences) {
    double rank = 0.5;
    for (const double other : differences) {
      rank += std::abs(other) < std::abs(difference) ? 1.0 : 0.0;
      rank += std::abs(other) == std::abs(difference) ? 0.5 : 0.0;
    }
    if (difference != 0.0) ranks.push_back(rank);
    if (difference > 0.0) observed += rank;
  }
  int as_large = 0, as_small = 0;
  const int patterns = 1 << ranks.size();
  for (int pattern = 0; pattern < patterns; ++pattern) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (pattern >> i & 1) != 0 ? ranks[i] : 0.0;
    as_large += sum >= observed;
    as_small += sum <= observed;
  }
  return {.signs = ranks.size(),
          .positive_sum = observed,
          .p_greater = static_cast<double>(as_large) / patterns,
          .p_less = static_cast<double>(as_small) / patterns};
}

/// Differences of the sizes 1 to n whose negative ones have this sum.
Values with_negative_sum(int n, int sum) {
  Values differences;
  for (int size = n; size > 0; --size) {
    const bool is_negative = size <= sum;
    if (is_negative) sum -= size;
    differences.push_back(is_negative ? -size : size);
  }
  return differences;
}

Values uniform_differences(std::uint64_t set, std::size_t count, double shift) {
  CounterStream stream(52, set);
  Values differences(count);
  for (double& value : differences) value = stream.next_unit() - shift;
  return differences;
}

Values negated(Values values) {
  for (double& value : values) value = -value;
  return values;
}

TEST(SignedRankTest, IsTheOneByHand) {
  // Of the 8 sums of some of {1, 2, 3} two are 5 or more, seven 5 or less.
  const SignedRankTest test = signed_rank_test(Values{0.2, -0.1, 0.3});
  EXPECT_EQ(test.signs, 3u);
  EXPECT_EQ(test.positive_sum, 5.0);
  EXPECT_EQ(test.p_greater, 2.0 / 8.0);
  EXPECT_EQ(test.p_less, 7.0 / 8.0);
  EXPECT_EQ(test.p_two_sided, 4.0 / 8.0);
}

// Darwin 1876, The Effects of Cross and Self Fertilisation, p. 16: heights of 15 pairs of maize,
// crossed less self-fertilised, in eighths of an inch.
TEST(SignedRankTest, OfDarwinsMaizeIsTheKnownOne) {
  const SignedRankTest test =
      signed_rank_test(Values{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48});
  EXPECT_EQ(test.positive_sum, 96.0);
  EXPECT_EQ(test.p_two_sided, 2.0 * 676.0 / 32768.0);
}

// Hollander and Wolfe 1973, Nonparametric Statistical Methods, p. 29: depression scale factors
// before and after; R prints V = 40, p = 0.01953.
TEST(SignedRankTest, OfDepressionScalesIsTheKnownOne) {
  const Values before{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const Values after{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  Values differences;
  for (std::size_t i = 0; i < before.size(); ++i) differences.push_back(before[i] - after[i]);
  const SignedRankTest test = signed_rank_test(differences);
  EXPECT_EQ(test.positive_sum, 40.0);
  EXPECT_EQ(test.p_greater, 10.0 / 512.0);
}

// Zeros keep the lowest ranks: 4, 5 and 6 are left, of whose 8 sums 9, 10, 11 and 15 reach 9. Had
// they been dropped first, five of the 8 sums of {1, 2, 3} would reach 3.
TEST(SignedRankTest, RanksZerosAndLeavesThemOut) {
  const SignedRankTest test = signed_rank_test(Values{0, 0, 0, 1, 2, -3});
  EXPECT_EQ(test.signs, 3u);
  EXPECT_EQ(test.positive_sum, 9.0);
  EXPECT_EQ(test.p_greater, 4.0 / 8.0);
}

TEST(SignedRankTest, OfNothingButZerosSaysNothing) {
  for (const std::size_t count : {0u, 1u, 5u, 100u}) {
    const SignedRankTest test = signed_rank_test(Values(count, 0.0));
    EXPECT_EQ(test.signs, 0u);
    EXPECT_EQ(test.p_greater, 1.0);
    EXPECT_EQ(test.p_less, 1.0);
    EXPECT_EQ(test.p_two_sided, 1.0);
  }
}

// The largest sums that are significant at 0.05, 0.025, 0.01 and 0.005 on one side, as McCornack
// tabulates them (1965, J. Am. Stat. Assoc. 60:864).
TEST(SignedRankTest, MeetsTheTableOfCriticalValues) {
  struct Row {
    int n;
    std::vector<int> critical;
  };
  const Values levels{0.05, 0.025, 0.01, 0.005};
  for (const Row& row :
       {Row{8, {5, 3, 1, 0}}, Row{10, {10, 8, 5, 3}}, Row{15, {30, 25, 19, 15}},
        Row{20, {60, 52, 43, 37}}, Row{25, {100, 89, 76, 68}}, Row{50, {466, 434, 397, 373}}})
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const int sum = row.critical[i];
      EXPECT_LE(signed_rank_test(with_negative_sum(row.n, sum)).p_greater, levels[i]) << row.n;
      EXPECT_GT(signed_rank_test(with_negative_sum(row.n, sum + 1)).p_greater, levels[i]) << row.n;
    }
}

// The normal law knows no steps, and where ties have made them smaller than a rank its correction
// for them is too large: it may be off by the probability of one rank's step at the middle, where
// that is largest, 1 / (standard deviation sqrt(2 pi)). The next term of the expansion is a third.
TEST(SignedRankTest, NormalLawMeetsTheExactOneWhereItTakesOver) {
  for (std::uint64_t set = 0; set < 20; ++set) {
    Values differences = uniform_differences(set, 61, 0.35 + 0.01 * static_cast<double>(set));
    if (set % 2 == 1)
      for (double& value : differences) value = std::round(10.0 * value);
    const SignedRankTest exact = signed_rank_test(differences, {.largest_exact = 100});
    const SignedRankTest normal = signed_rank_test(differences, {.largest_exact = 0});
    EXPECT_NE(exact.p_greater, normal.p_greater);
    const double step = 1.0 / std::sqrt(2.0 * std::numbers::pi * 61.0 * 62.0 * 123.0 / 24.0);
    EXPECT_NEAR(exact.p_greater, normal.p_greater, step);
    EXPECT_NEAR(exact.p_less, normal.p_less, step);
  }
}

TEST(SignedRankTest, RefusesWhatIsNotFinite) {
  EXPECT_THROW(signed_rank_test(Values{1, NAN}), ContractViolation);
  EXPECT_THROW(signed_rank_test(Values{1, INFINITY}), ContractViolation);
}

TEST(SignedRankTestOracle, AgreesWithAllSignPatterns) {
  for (std::size_t count = 1; count <= 12; ++count)
    for (std::uint64_t set = 0; set < 6; ++set) {
      Values differences = uniform_differences(100 * count + set, count, 0.4);
      // Every other sample has ties and zeros.
      if (set % 2 == 1)
        for (double& value : differences) value = std::round(5.0 * value);
      const SignedRankTest test = signed_rank_test(differences);
      const SignedRankTest expected = by_all_patterns(differences);
      EXPECT_EQ(test.signs, expected.signs);
      EXPECT_EQ(test.positive_sum, expected.positive_sum);
      EXPECT_EQ(test.p_greater, expected.p_greater);
      EXPECT_EQ(test.p_less, expected.p_less);
    }
}

TEST(SignedRankTestLaw, NegatedDifferencesSwapTheSides) {
  for (const std::size_t count : {1u, 7u, 30u, 60u, 61u, 200u}) {
    const Values differences = uniform_differences(count, count, 0.45);
    const SignedRankTest test = signed_rank_test(differences);
    const SignedRankTest mirrored = signed_rank_test(negated(differences));
    EXPECT_NEAR(test.p_greater, mirrored.p_less, sign_rounding);
    EXPECT_NEAR(test.p_less, mirrored.p_greater, sign_rounding);
    EXPECT_NEAR(test.p_two_sided, mirrored.p_two_sided, sign_rounding);
  }
}

TEST(SignedRankTestLaw, KnowsNeitherOrderNorScale) {
  const Values differences = uniform_differences(3, 20, 0.3);
  Values changed(differences.rbegin(), differences.rend());
  for (double& value : changed) value *= 1024.0;
  EXPECT_NEAR(signed_rank_test(differences).p_greater, signed_rank_test(changed).p_greater,
              sign_rounding);
}

TEST(SignedRankTestLaw, BothSidesTogetherCountTheSumTwice) {
  for (const std::size_t count : {1u, 5u, 40u, 60u, 61u, 300u}) {
    const SignedRankTest test = signed_rank_test(uniform_differences(count, count, 0.5));
    EXPECT_GT(test.p_greater + test.p_less, 1.0);
    EXPECT_LE(std::max({test.p_greater, test.p_less, test.p_two_sided}), 1.0);
    EXPECT_GT(std::min(test.p_greater, test.p_less), 0.0);
  }
}

// Over all sign patterns of one set of sizes: what a test is for.
TEST(SignedRankTestLaw, AlarmsNoMoreOftenThanItSays) {
  const Values sizes{1, 2, 2, 4, 5, 6, 6, 6, 9};
  for (const double level : {0.005, 0.01, 0.05, 0.1, 0.5}) {
    int alarms = 0, doubled_alarms = 0;
    for (int pattern = 0; pattern < 512; ++pattern) {
      Values differences = sizes;
      for (std::size_t i = 0; i < sizes.size(); ++i)
        if ((pattern >> i & 1) != 0) differences[i] = -sizes[i];
      const SignedRankTest test = signed_rank_test(differences);
      alarms += test.p_greater <= level;
      doubled_alarms += test.p_two_sided <= level;
    }
    EXPECT_LE(alarms, 512 * level);
    EXPECT_LE(doubled_alarms, 512 * level);
    EXPECT_GT(alarms, 0);
  }
}

}  // namespace
}  // namespace phytobench
