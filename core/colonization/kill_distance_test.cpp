// SPDX-License-Identifier: MIT
#include "core/colonization/kill_distance.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double distance_rounding = 1e-12;  // a few floating-point operations on numbers near 1

/// The thesis' worked example.
KillDistanceSchedule worked_example(KillInterpolation interpolation) {
  return {.begin = 2.0,
          .end = 1.2,
          .sigmoid_begin = -8.0,
          .sigmoid_end = 8.0,
          .interpolation = interpolation};
}

// [Brzoska2019] eq. 18 to 20 print 2.0, 1.655 and 1.2; more digits by hand from eq. 17.
TEST(KillDistanceSchedule, GivesTheWorkedExamplesOfTheThesis) {
  constexpr double printed_rounding = 1e-6;
  const KillDistanceSchedule schedule = worked_example(KillInterpolation::linear);
  EXPECT_NEAR(schedule.at(0, 30), 1.999732, printed_rounding);
  EXPECT_NEAR(schedule.at(14, 30), 1.654825, printed_rounding);
  EXPECT_NEAR(schedule.at(29, 30), 1.200268, printed_rounding);
}

TEST(KillDistanceSchedule, InterpolatesSquaresBetweenTheSameEnds) {
  KillDistanceSchedule schedule = worked_example(KillInterpolation::squared);
  EXPECT_NEAR(schedule.at(1, 3), std::sqrt((4.0 + 1.44) / 2.0),
              distance_rounding);  // sigmoid(0) is one half
  schedule.sigmoid_begin = -50.0;
  schedule.sigmoid_end = 50.0;
  EXPECT_NEAR(schedule.at(0, 30), 2.0, distance_rounding);
  EXPECT_NEAR(schedule.at(29, 30), 1.2, distance_rounding);
}

TEST(KillDistanceSchedule, DefaultIsTheSquare) {
  EXPECT_EQ(KillDistanceSchedule{}.interpolation, KillInterpolation::squared);
}

TEST(KillDistanceSchedule, OfASingleIterationIsItsBegin) {
  for (const KillInterpolation kind : {KillInterpolation::squared, KillInterpolation::linear})
    EXPECT_EQ(worked_example(kind).at(0, 1), 2.0);
}

TEST(KillDistanceSchedule, OfEqualEndsIsConstant) {
  const KillDistanceSchedule schedule{.begin = 0.3, .end = 0.3};
  for (int i = 0; i < 10; ++i) EXPECT_EQ(schedule.at(i, 10), 0.3);
}

TEST(KillDistanceSchedule, RefusesIterationsThatDoNotExist) {
  const KillDistanceSchedule schedule;
  EXPECT_THROW(schedule.at(-1, 30), ContractViolation);
  EXPECT_THROW(schedule.at(30, 30), ContractViolation);
  EXPECT_THROW(schedule.at(0, 0), ContractViolation);
}

TEST(KillDistanceScheduleLaw, ShrinksFromBeginToEnd) {
  for (const KillInterpolation kind : {KillInterpolation::squared, KillInterpolation::linear}) {
    const KillDistanceSchedule schedule = worked_example(kind);
    double previous = schedule.begin;
    for (int i = 0; i < 100; ++i) {
      const double distance = schedule.at(i, 100);
      ASSERT_LT(distance, previous) << "iteration " << i;
      ASSERT_GT(distance, schedule.end) << "iteration " << i;
      previous = distance;
    }
  }
}

TEST(KillDistanceScheduleLaw, SquaresLieAboveDistances) {
  const KillDistanceSchedule squared = worked_example(KillInterpolation::squared);
  const KillDistanceSchedule linear = worked_example(KillInterpolation::linear);
  for (int i = 0; i < 30; ++i) EXPECT_GT(squared.at(i, 30), linear.at(i, 30)) << "iteration " << i;
}

TEST(Sigmoid, GivesTheWorkedExampleOfTheThesis) {
  EXPECT_NEAR(sigmoid(-0.276), 0.431, 5e-4);  // printed with three digits
  EXPECT_EQ(sigmoid(0.0), 0.5);
}

TEST(SigmoidLaw, IsPointSymmetricAboutOneHalf) {
  for (const double x : {0.1, 1.0, 5.0, 30.0, 700.0})
    EXPECT_NEAR(sigmoid(-x) + sigmoid(x), 1.0, distance_rounding) << x;
}

TEST(GnarlinessCoupling, HasTheEndPointsItsAuthorPublished) {
  const GnarlinessCoupling straight = couple_to_gnarliness(0.0);
  EXPECT_EQ(straight.influence_distance, 1.3);
  EXPECT_EQ(straight.kill_distance_min, 0.1);
  EXPECT_EQ(straight.kill_distance_max, 1.25);
  EXPECT_EQ(straight.cloud_density, 12.0);
  const GnarlinessCoupling gnarled = couple_to_gnarliness(1.0);
  EXPECT_NEAR(gnarled.influence_distance, 0.5, distance_rounding);
  EXPECT_NEAR(gnarled.kill_distance_min, 0.05, distance_rounding);
  EXPECT_NEAR(gnarled.kill_distance_max, 0.4125, distance_rounding);
  EXPECT_NEAR(gnarled.cloud_density, 30.0, distance_rounding);
}

TEST(GnarlinessCoupling, GivesTheStartSettings) {
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.8);
  EXPECT_NEAR(coupling.influence_distance, 0.66, distance_rounding);
  EXPECT_NEAR(coupling.kill_distance(0.0), 0.58, distance_rounding);
  EXPECT_NEAR(coupling.kill_distance(0.8), 0.2649, 5e-5);  // published with four digits
  EXPECT_NEAR(coupling.cloud_density, 26.4, distance_rounding);
}

TEST(GnarlinessCoupling, IsLinearInTheSquareOfTheKillDistance) {
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.3);
  const double largest = coupling.kill_distance_max, smallest = coupling.kill_distance_min;
  EXPECT_NEAR(coupling.kill_distance(0.0), largest, distance_rounding);
  EXPECT_NEAR(coupling.kill_distance(1.0), smallest, distance_rounding);
  EXPECT_NEAR(coupling.kill_distance(0.5),
              std::sqrt((largest * largest + smallest * smallest) / 2.0), distance_rounding);
}

TEST(GnarlinessCoupling, RefusesWhatIsNoShare) {
  EXPECT_THROW(couple_to_gnarliness(-0.1), ContractViolation);
  EXPECT_THROW(couple_to_gnarliness(1.1), ContractViolation);
  EXPECT_THROW(couple_to_gnarliness(std::numeric_limits<double>::quiet_NaN()), ContractViolation);
}

TEST(GnarlinessCouplingLaw, NeverKillsBeyondTheInfluenceDistance) {
  for (int percent = 0; percent <= 100; ++percent) {
    const GnarlinessCoupling coupling = couple_to_gnarliness(percent / 100.0);
    EXPECT_LT(coupling.kill_distance_max, coupling.influence_distance) << percent << " %";
    EXPECT_LT(coupling.kill_distance_min, coupling.kill_distance_max) << percent << " %";
  }
}

}  // namespace
}  // namespace phytobench
