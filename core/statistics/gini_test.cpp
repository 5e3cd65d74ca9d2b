// SPDX-License-Identifier: MIT
#include "core/statistics/gini.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

Values random_values(std::size_t count, std::uint64_t number) {
  CounterStream stream(7, number);
  Values values;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = stream.next_unit();
    values.push_back(u * u * u);
  }
  return values;
}

TEST(Gini, IsWhatTheDefinitionGives) {
  for (std::uint64_t number = 0; number < 20; ++number) {
    const Values x = random_values(1 + 7 * number, number);
    double differences = 0.0, sum = 0.0;
    for (const double a : x) {
      sum += a;
      for (const double b : x) differences += std::abs(a - b);
    }
    const auto n = static_cast<double>(x.size());
    EXPECT_NEAR(gini_coefficient(x), differences / (2.0 * n * n * (sum / n)), 1e-14);
  }
}

TEST(Gini, OfTwoIsTheirDifferenceOverTwiceTheirSum) {
  EXPECT_NEAR(gini_coefficient(Values{1, 2}), 1.0 / 6.0, 1e-16);
  EXPECT_EQ(gini_coefficient(Values{0, 5}), 0.5);
}

TEST(GiniLaw, IsZeroForEqualValuesAndLargestWhereOneHasEverything) {
  EXPECT_EQ(gini_coefficient(Values(1000, 0.1)), 0.0);
  EXPECT_EQ(gini_coefficient(Values(3, 0.0)), 0.0);
  EXPECT_EQ(gini_coefficient(Values{4}), 0.0);
  Values one(10, 0.0);
  one[3] = 7.0;
  EXPECT_NEAR(gini_coefficient(one), 0.9, 1e-15);
}

TEST(GiniLaw, KnowsNeitherOrderNorUnitNorCopies) {
  Values x = random_values(100, 1);
  const double gini = gini_coefficient(x);
  std::reverse(x.begin(), x.end());
  EXPECT_EQ(gini_coefficient(x), gini);
  Values scaled, twice;
  for (const double value : x) {
    scaled.push_back(4.0 * value);
    twice.push_back(value);
    twice.push_back(value);
  }
  EXPECT_EQ(gini_coefficient(scaled), gini) << "a power of two changes no digit";
  EXPECT_NEAR(gini_coefficient(twice), gini, 1e-14);
}

TEST(GiniLaw, FallsWhereARichOneGivesToAPoorOneAndWhereAllGetTheSame) {
  Values x = random_values(50, 2);
  const double gini = gini_coefficient(x);
  Values added = x;
  for (double& value : added) value += 0.1;
  EXPECT_LT(gini_coefficient(added), gini);
  const auto [poor, rich] = std::minmax_element(x.begin(), x.end());
  const double gift = 0.1 * (*rich - *poor);
  *poor += gift;
  *rich -= gift;
  EXPECT_LT(gini_coefficient(x), gini);
}

// Uniform numbers: 1/3; squares and cubes of them 1/2 and 3/5, in general p / (p + 2).
TEST(GiniLaw, NearsThatOfTheDistribution) {
  EXPECT_NEAR(gini_coefficient(random_values(20'000, 3)), 0.6, 0.01);
}

TEST(Lorenz, RunsBelowTheDiagonalAndEnclosesHalfTheCoefficient) {
  const Values x = random_values(300, 4);
  const auto curve = lorenz_curve(x);
  ASSERT_EQ(curve.size(), 301u);
  EXPECT_EQ(curve.front().share_of_sum, 0.0);
  EXPECT_EQ(curve.back().share_of_number, 1.0);
  EXPECT_EQ(curve.back().share_of_sum, 1.0);
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_GE(curve[i].share_of_sum, curve[i - 1].share_of_sum);
    EXPECT_LE(curve[i].share_of_sum, curve[i].share_of_number);
    area += 0.5 * (curve[i].share_of_sum + curve[i - 1].share_of_sum) / 300.0;
  }
  EXPECT_NEAR(1.0 - 2.0 * area, gini_coefficient(x), 1e-13);
}

TEST(Gini, RefusesWhatHasNoInequality) {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(gini_coefficient(Values{1, bad}), ContractViolation) << bad;
    EXPECT_THROW(lorenz_curve(Values{1, bad}), ContractViolation) << bad;
  }
  EXPECT_THROW(gini_coefficient({}), ContractViolation);
  EXPECT_THROW(lorenz_curve({}), ContractViolation);
  EXPECT_THROW(lorenz_curve(Values{0, 0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
