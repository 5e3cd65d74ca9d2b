// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "core/competition/test_stands.hpp"
#include "core/overlap/test_discs.hpp"

namespace phytobench {
namespace {

using testing_discs::infinite;
using testing_stands::crowded_stand;
using testing_stands::losses;
using testing_stands::TestStand;
using testing_stands::with_exponent;

TEST(ExactSharesLaw, NobodyLosesMoreThanAllOrMoreThanByPairs) {
  for (const bool torus : {false, true})
    for (const double exponent : {0.0, 1.0, 5.0, infinite})
      for (const TieRule ties : {TieRule::share, TieRule::lower_id_wins}) {
        const TestStand stand = crowded_stand(300, torus);
        const CompetitionParameters parameters = with_exponent(exponent, ties);
        const std::vector<double> exact = losses("exact_shares", parameters, stand);
        const std::vector<double> pairs = losses("asymmetry_exponent", parameters, stand);
        double largest = 0.0;
        for (std::size_t i = 0; i < stand.size(); ++i) {
          EXPECT_GE(exact[i], -1e-12) << i;
          EXPECT_LE(exact[i], 1.0) << i;
          EXPECT_LE(exact[i], pairs[i] + 1e-11) << i;
          largest = std::max(largest, pairs[i]);
        }
        EXPECT_GT(largest, 1.5);  // which says that more than the whole plant is lost
      }
}

TEST(ExactSharesLaw, OfTwoPlantsAreThoseOfPairs) {
  for (const double exponent : {0.0, 0.4, 1.0, 6.0, infinite})
    for (const double second : {0.7, 1.0, 3.0}) {
      TestStand stand;
      stand.add(0, 0, 1.0, 1.0);
      stand.add(0.9, 0.3, second, 1.0);
      const CompetitionParameters parameters = with_exponent(exponent);
      const std::vector<double> exact = losses("exact_shares", parameters, stand);
      const std::vector<double> pairs = losses("asymmetry_exponent", parameters, stand);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(exact[i], pairs[i], 1e-13) << i;
    }
}

/// n neighbours at one place leave 1 / (n + 1); by pairs they take n / 2.
TEST(ExactShares, OfCoincidentPlantsLeaveEachItsPart) {
  const CompetitionParameters parameters = with_exponent(0.0);
  TestStand stand;
  for (int n = 0; n < 5; ++n) {
    stand.add(1, 1, 2, 2);
    for (const double loss : losses("exact_shares", parameters, stand))
      EXPECT_NEAR(loss, n / (n + 1.0), 1e-14);
    for (const double loss : losses("symmetric", parameters, stand))
      EXPECT_NEAR(loss, n / 2.0, 1e-14);
  }
}

TEST(ExactShares, OfEqualPlantsGoToTheLowestId) {
  const CompetitionParameters parameters = with_exponent(infinite, TieRule::lower_id_wins);
  TestStand stand;
  for (int n = 0; n < 3; ++n) stand.add(1, 1, 2, 2);
  stand.id = {8, 3, 5};
  const std::vector<double> loss = losses("exact_shares", parameters, stand);
  EXPECT_NEAR(loss[0], 1.0, 1e-14);
  EXPECT_NEAR(loss[1], 0.0, 1e-14);
  EXPECT_NEAR(loss[2], 1.0, 1e-14);
  stand.id.clear();
  EXPECT_NEAR(losses("exact_shares", parameters, stand)[0], 0.0, 1e-14);
}

}  // namespace
}  // namespace phytobench
