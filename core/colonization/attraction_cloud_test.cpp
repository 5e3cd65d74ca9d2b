// SPDX-License-Identifier: MIT
#include "core/colonization/attraction_cloud.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/colonization/test_streams.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double cloud_rounding = 1e-12;  // a few floating-point operations on numbers below 100

const std::vector<CutEllipsoid>& shapes() {
  static const std::vector<CutEllipsoid> all{
      {},
      {.radii = {1, 1, 1}, .cutoff_bottom = 0.0, .cutoff_top = 0.0},
      {.radii = {3, 1, 2}, .cutoff_bottom = 0.5, .cutoff_top = 0.0},
      {.radii = {0.5, 4, 6}, .cutoff_bottom = 0.6, .cutoff_top = 0.2},
  };
  return all;
}

std::vector<Vector3> sample(const CutEllipsoid& shape, std::size_t count, const Vector3& root) {
  CounterStream stream(1, 0);
  return attraction_points(shape, count, root, stream);
}

TEST(UnitSegmentVolume, OfKnownCutsIsKnown) {
  EXPECT_NEAR(unit_segment_volume(0.0, 0.0), 4.188790204786391, cloud_rounding);
  EXPECT_NEAR(unit_segment_volume(0.15, 0.05), 3.903952470860916, cloud_rounding);
  EXPECT_NEAR(unit_segment_volume(0.5, 0.0), 2.0943951023931957, cloud_rounding);
}

TEST(UnitSegmentVolume, RefusesCutsThatLeaveNothing) {
  EXPECT_THROW(unit_segment_volume(0.5, 0.5), ContractViolation);
  EXPECT_THROW(unit_segment_volume(0.9, 0.2), ContractViolation);
  EXPECT_THROW(unit_segment_volume(-0.1, 0.0), ContractViolation);
  EXPECT_THROW(unit_segment_volume(0.0, -0.1), ContractViolation);
  EXPECT_THROW(unit_segment_volume(std::numeric_limits<double>::quiet_NaN(), 0.0),
               ContractViolation);
}

TEST(UnitSegmentVolumeLaw, IsSymmetricInTopAndBottom) {
  for (const double cut : {0.05, 0.2, 0.45})
    EXPECT_NEAR(unit_segment_volume(cut, 0.1), unit_segment_volume(0.1, cut), cloud_rounding);
}

TEST(UnitSegmentVolumeLaw, OfThePartsAddsUpToTheWhole) {
  for (const double cut : {0.1, 0.3, 0.5, 0.8})
    EXPECT_NEAR(unit_segment_volume(cut, 0.0) + unit_segment_volume(0.0, 1.0 - cut),
                unit_segment_volume(0.0, 0.0), cloud_rounding);
}

TEST(AttractionPointCount, IsVolumeTimesDensityRoundedUp) {
  EXPECT_EQ(attraction_point_count({.radii = {6, 6, 6}}, 30.0), 25298u);
  EXPECT_EQ(attraction_point_count({}, 26.4), 16233u);  // 16232.63
  EXPECT_EQ(attraction_point_count({}, 0.0), 0u);
  EXPECT_EQ(attraction_point_count({}, 1e-9), 1u);
}

TEST(AttractionPointCount, BeyondAnIndexIsAnInputError) {
  EXPECT_THROW(attraction_point_count({}, 1e12), InputError);
  EXPECT_THROW(attraction_point_count({}, std::numeric_limits<double>::infinity()), InputError);
  EXPECT_THROW(attraction_point_count({}, std::numeric_limits<double>::quiet_NaN()), InputError);
}

TEST(AttractionPointCount, OfCutsThatLeaveNothingIsAContractViolation) {
  EXPECT_THROW(attraction_point_count({.cutoff_bottom = 0.4, .cutoff_top = 0.6}, 1.0),
               ContractViolation);
}

// A height outside the planes restarts at once; a point outside the sphere costs three numbers.
TEST(AttractionPoints, AreDrawnHeightFirst) {
  ScriptedStream stream({0.0,                // y = -1: below the bottom plane
                         0.99,               // y = 0.98: above the top plane
                         0.75, 0.99, 0.5,    // y = 0.5, x = 0.98: outside the sphere
                         0.5, 0.25, 0.75});  // y = 0, x = -0.5, z = 0.5
  const auto points = attraction_points({}, 1, {0, 0, 0}, stream);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(stream.used(), 8u);
  EXPECT_NEAR(points[0].x, -2.5, cloud_rounding);
  EXPECT_NEAR(points[0].y, 4.9,
              cloud_rounding);  // the centre lies 7 - 0.15 * 14 above the crown root
  EXPECT_NEAR(points[0].z, 2.25, cloud_rounding);
}

TEST(AttractionPoints, CanBeNone) {
  EXPECT_TRUE(sample({}, 0, {0, 0, 0}).empty());
}

TEST(AttractionPointsLaw, LieInsideTheCutEllipsoid) {
  const Vector3 root{3, 5, -2};
  for (const CutEllipsoid& shape : shapes()) {
    const double centre_y = root.y + shape.radii.y * (1.0 - 2.0 * shape.cutoff_bottom);
    const auto points = sample(shape, 500, root);
    ASSERT_EQ(points.size(), 500u);
    for (const Vector3& point : points) {
      const Vector3 unit{(point.x - root.x) / shape.radii.x, (point.y - centre_y) / shape.radii.y,
                         (point.z - root.z) / shape.radii.z};
      ASSERT_LE(squared_norm(unit), 1.0 + cloud_rounding);
      ASSERT_GE(unit.y, -1.0 + 2.0 * shape.cutoff_bottom - cloud_rounding);
      ASSERT_LE(unit.y, 1.0 - 2.0 * shape.cutoff_top + cloud_rounding);
    }
  }
}

TEST(AttractionPointsLaw, StandOnTheCrownRoot) {
  const Vector3 root{3, 5, -2};
  for (const CutEllipsoid& shape : shapes()) {
    const BoundingBox box = extent_of(sample(shape, 2000, root));
    const double height = 2.0 * shape.radii.y * (1.0 - shape.cutoff_bottom - shape.cutoff_top);
    EXPECT_GE(box.low().y, root.y - cloud_rounding);
    // The lowest and the highest tenth hold at least 1.4 % of any of these volumes, so 2000 points
    // leave one of them empty with a probability of exp(-28).
    EXPECT_LE(box.low().y, root.y + 0.1 * height);
    EXPECT_LE(box.high().y, root.y + height + cloud_rounding);
    EXPECT_GE(box.high().y, root.y + 0.9 * height);
  }
}

TEST(AttractionPointsLaw, MorePointsKeepTheFirstOnes) {
  const auto few = sample({}, 100, {0, 1, 0});
  auto many = sample({}, 200, {0, 1, 0});
  many.resize(100);
  EXPECT_EQ(few, many);
}

TEST(ExtentOf, IsTheSmallestBox) {
  EXPECT_TRUE(extent_of({}).empty());
  const BoundingBox box = extent_of({{1, 5, -3}, {2, -5, 0}});
  EXPECT_EQ(box.low(), (Vector3{1, -5, -3}));
  EXPECT_EQ(box.high(), (Vector3{2, 5, 0}));
}

}  // namespace
}  // namespace phytobench
