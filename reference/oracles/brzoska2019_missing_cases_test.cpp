// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_missing_cases.hpp"

#include <gtest/gtest.h>

namespace phytobench::oracles::brzoska2019 {
namespace {

TEST(MissingCasesOracle, TubesAreOpenAtBothEndsAndTetrahedraAreClosed) {
  for (int corners = 3; corners < 9; ++corners)
    for (int rings = 2; rings < 6; ++rings)
      EXPECT_EQ(open_sides(triangles_of_tube(corners, rings)), 2 * corners);
  EXPECT_EQ(triangles_of_tube(6, 4).size(), 36u);
  EXPECT_EQ(open_sides({{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}), 0);
}

TEST(MissingCasesOracle, BendingTurnsByPsiTowardsTheGround) {
  for (double theta = 1; theta < 180; ++theta)
    for (const double lambda : {0.0, 0.4, 0.8, 1.0}) {
      const double angle = theta * std::numbers::pi / 180;
      const Point bent = bent_corrected({std::sin(angle), -std::cos(angle), 0}, lambda);
      const double after = (theta - equation_13(theta, lambda)) * std::numbers::pi / 180;
      EXPECT_NEAR(bent.x, std::sin(after), 1e-12);
      EXPECT_NEAR(bent.y, -std::cos(after), 1e-12);
      EXPECT_EQ(bent.z, 0);
    }
}

TEST(MissingCasesOracle, UprightAndHangingBranchesStay) {
  EXPECT_EQ(bent_corrected({0, 2, 0}, 0.8).y, 2);
  EXPECT_EQ(bent_corrected({0, -2, 0}, 0.8).y, -2);
  EXPECT_TRUE(std::isnan(bent_as_printed({0, 2, 0}, 0.8).y));
}

TEST(MissingCasesOracle, LeavesAndPointsOfPlantsThatTheThesisCounts) {
  EXPECT_EQ(leaves_of_plant(21122, 2243, 3), 958);  // figure 40 right
  EXPECT_EQ(leaves_of_plant(13458, 2243, 3), 0);    // figure 40 left
  EXPECT_EQ(points_of_cloud({1, 1, 1}, 1000, 0), 4189);
  EXPECT_EQ(points_of_cloud({1, 1, 1}, 1000, 0.5), 2095);
}

}  // namespace
}  // namespace phytobench::oracles::brzoska2019
