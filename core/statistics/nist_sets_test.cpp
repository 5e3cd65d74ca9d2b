// SPDX-License-Identifier: MIT
#include "core/statistics/nist_sets.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(NistSets, HaveTheirNumberOfObservations) {
  std::vector<std::size_t> counts;
  for (const UnivariateSet& set : nist_univariate_sets()) counts.push_back(set.values.size());
  for (const RegressionSet& set : nist_regression_sets()) {
    EXPECT_EQ(set.x.size(), set.y.size());
    EXPECT_EQ(set.coefficients.size(), static_cast<std::size_t>(set.degree) + 1);
    counts.push_back(set.x.size());
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{3, 1001, 1001, 1001, 36, 21, 21, 21, 21, 21}));
}

TEST(NistSets, HoldThePrintedValues) {
  const auto univariate = nist_univariate_sets();
  EXPECT_EQ(univariate[3].values[0], 10000000.2);
  EXPECT_EQ(univariate[3].values[999], 10000000.1);
  EXPECT_EQ(univariate[3].values[1000], 10000000.3);
  const auto sets = nist_regression_sets();
  EXPECT_EQ(sets[1].y[13], 402234.0);
  EXPECT_EQ(sets[1].y[20], 3368421.0);
  EXPECT_EQ(sets[2].y[1], 1.11111);
  EXPECT_EQ(sets[2].y[14], 16.32384);
  EXPECT_EQ(sets[2].y[19], 51.16209);
  EXPECT_EQ(sets[3].y[1], -2042.0);
  EXPECT_EQ(sets[3].y[5], 1858.0);
  EXPECT_EQ(sets[4].y[0], 75901.0);
  EXPECT_EQ(sets[4].y[16], 1370781.0);
  EXPECT_EQ(sets[5].y[19], -17866340.0);
  EXPECT_EQ(sets[5].y[20], 10958421.0);
}

// The certified sum of squared residuals of Wampler3, 83554268, is that of what it adds.
TEST(NistSets, AddWhatTheCertifiedResidualsSay) {
  const auto sets = nist_regression_sets();
  for (std::size_t k = 3; k < sets.size(); ++k) {
    double squares = 0.0;
    for (std::size_t i = 0; i < sets[k].y.size(); ++i) {
      const double added = sets[k].y[i] - sets[1].y[i];
      squares += added * added;
    }
    const double factor = k == 3 ? 1.0 : k == 4 ? 1e4 : 1e8;
    EXPECT_EQ(squares, 83554268.0 * factor) << sets[k].name;
    const double certified = sets[k].residual_deviation * sets[k].residual_deviation * 15.0;
    EXPECT_NEAR(certified / squares, 1.0, 1e-14) << sets[k].name;
  }
}

}  // namespace
}  // namespace phytobench
