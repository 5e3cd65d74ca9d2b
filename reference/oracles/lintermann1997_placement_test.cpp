// SPDX-License-Identifier: MIT
#include "reference/oracles/lintermann1997_placement.hpp"

#include <gtest/gtest.h>

namespace phytobench::oracles::lintermann1997 {
namespace {

TEST(SuccessorValues, AsPrintedAreNotOfTheirRange) {
  const double from_zero[] = {0, 2.5, 5, 7.5, 10};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(v_i_as_printed(10, 20, 5, i), from_zero[i]);
  EXPECT_EQ(v_i_as_printed(10, 20, 5, 5), 12.5);
  EXPECT_TRUE(std::isinf(v_i_as_printed(10, 20, 1, 1)));
  EXPECT_TRUE(std::isnan(v_i_as_printed(10, 20, 1, 0)));
}

TEST(SuccessorValues, CorrectedGoFromOneEndToTheOther) {
  const double values[] = {10, 12.5, 15, 17.5, 20};
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(v_i_corrected(10, 20, 5, i), values[i - 1]);
  EXPECT_EQ(v_i_corrected(10, 20, 1, 1), 10);
  EXPECT_EQ(v_i_as_printed(0, 20, 5, 3), v_i_corrected(0, 20, 5, 4));  // right for v_0 = 0
}

TEST(HornBendingLaw, TotalTurnIsTheMeanTimesTheJoints) {
  for (int m = 2; m <= 30; ++m) {
    double total = 0;
    for (int joint = 1; joint <= m; ++joint) total += turn_at_joint(3, -7.5, m, joint);
    EXPECT_NEAR(total, total_turn(3, -7.5, m), 1e-12);
  }
  EXPECT_EQ(hydra_step_deg(18), 20);
}

TEST(GoldenAngle, IsTheSmallerPartOfTheGoldenSection) {
  const double golden = golden_angle_deg();
  EXPECT_NEAR(golden, 137.507764, 5e-7);
  EXPECT_NEAR((360 - golden) / golden, std::numbers::phi, 1e-14);
  EXPECT_NEAR(360 / (360 - golden), std::numbers::phi, 1e-14);
  EXPECT_NEAR(azimuth_deg(7) - azimuth_deg(6), golden, 1e-12);
}

TEST(SphereCapLaw, PlacesAreOnTheCapAndShareItEqually) {
  for (const double to : {30.0, 90.0, 180.0}) {
    const std::vector<Place> places = places_on_cap(50, 2, 10, to);
    const double rad = std::numbers::pi / 180;
    const double band = (std::cos(10 * rad) - std::cos(to * rad)) / 50;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place p = places[i];
      EXPECT_NEAR(std::hypot(p.x, p.y, p.z), 2, 1e-14);
      EXPECT_LT(p.z, 2 * std::cos(10 * rad));
      EXPECT_GT(p.z, 2 * std::cos(to * rad));
      // The area of a band is 2 pi r h: equal heights.
      if (i > 0) EXPECT_NEAR(places[i - 1].z - p.z, 2 * band, 1e-14);
    }
  }
}

TEST(SphereCap, SeparatesItsPlacesAsTheNumberAsks) {
  EXPECT_NEAR(separation_constant(100), 3.0904, 5e-5);
  EXPECT_NEAR(separation_constant(300), 3.0915, 5e-5);
  EXPECT_NEAR(separation_constant(1000), 3.0919, 5e-5);
  for (const int N : {100, 300, 1000})
    EXPECT_LT(distance_of_centroid(places_on_cap(N, 1, 0, 180)), 2.5e-4);
}

TEST(Disc, HasItsClosestPairAtOneAndFour) {
  const ClosestPair closest = closest_pair(places_on_disc(500));
  EXPECT_EQ(closest.first + 1, 1u);
  EXPECT_EQ(closest.second + 1, 4u);
  EXPECT_NEAR(closest.distance, 1.6019502, 5e-8);
  const double rad = std::numbers::pi / 180;
  EXPECT_NEAR(closest.distance, std::sqrt(5 - 4 * std::cos(3 * golden_angle_deg() * rad)), 1e-12);
}

TEST(BushLeafForm, IsThatOfThreeParallelograms) {
  EXPECT_NEAR(leaf_area(22.5), 1.4724736, 5e-8);
  EXPECT_NEAR(leaf_extent(22.5).first, 2.8477591, 5e-8);
  EXPECT_NEAR(leaf_extent(22.5).second, 0.7653669, 5e-8);
  EXPECT_NEAR(leaf_area(60), 1.5 * std::sqrt(3.0), 1e-14);  // a regular hexagon
}

}  // namespace
}  // namespace phytobench::oracles::lintermann1997
