// SPDX-License-Identifier: MIT
#include "core/colonization/attraction_region.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr std::size_t many = 20000;
constexpr double radius_rounding = 1e-12;  // relative to the radius

std::vector<Vector3> sample(const RoundRegion& region, std::uint64_t seed = 1,
                            std::size_t count = many) {
  return attraction_points(region, count, *make_stream(StreamKind::counter, seed, 1));
}

constexpr Vector3 region_centre{3, -4, 5};
const RoundRegion disc{RoundShape::disc, 500.0, 0.0, region_centre};
const RoundRegion annulus{RoundShape::annulus, 500.0, 300.0, region_centre};
const RoundRegion ring{RoundShape::ring, 500.0, 0.0, region_centre};
const RoundRegion shell{RoundShape::sphere_shell, 500.0, 300.0, region_centre};
const RoundRegion sphere{RoundShape::sphere_shell, 500.0, 500.0, region_centre};

TEST(AttractionRegion, HoldsItsPoints) {
  for (const RoundRegion& region : {disc, annulus, ring, shell, sphere}) {
    const bool is_line = region.shape == RoundShape::ring;
    const double inner = is_line ? region.radius : region.inner_radius;
    for (const Vector3& point : sample(region)) {
      const double distance = norm(point - region_centre);
      ASSERT_GE(distance, inner * (1.0 - radius_rounding));
      ASSERT_LE(distance, region.radius * (1.0 + radius_rounding));
      if (region.shape != RoundShape::sphere_shell) {
        ASSERT_EQ(point.z, region_centre.z);
      }
    }
  }
}

/// Mean over the points of the distance to the centre to this power.
double mean_power(const RoundRegion& region, double power) {
  double sum = 0.0;
  for (const Vector3& point : sample(region))
    sum += std::pow(norm(point - region_centre) / region.radius, power);
  return sum / static_cast<double>(many);
}

// r^2 is uniform between its bounds in the plane, r^3 in space. Five standard errors.
TEST(AttractionRegionLaw, IsFilledUniformly) {
  const auto expect_uniform = [](double mean, double low) {
    const double error = (1.0 - low) / std::sqrt(12.0 * static_cast<double>(many));
    EXPECT_NEAR(mean, 0.5 * (1.0 + low), 5.0 * error);
  };
  expect_uniform(mean_power(disc, 2.0), 0.0);
  expect_uniform(mean_power(annulus, 2.0), 0.36);
  expect_uniform(mean_power(shell, 3.0), 0.216);
}

TEST(AttractionRegionLaw, HasNoPreferredSide) {
  for (const RoundRegion& region : {disc, annulus, ring, shell, sphere}) {
    Vector3 mean;
    for (const Vector3& point : sample(region)) mean = mean + (point - region_centre);
    // A coordinate's standard deviation is at most the radius over the root of 2.
    const double error = region.radius * std::sqrt(0.5 / static_cast<double>(many));
    for (const double component : {mean.x, mean.y, mean.z})
      EXPECT_LT(std::abs(component) / static_cast<double>(many), 5.0 * error);
  }
}

// Archimedes: the height on a sphere is uniform.
TEST(AttractionRegionLaw, SphereHasAsManyPointsNearItsPolesAsItsAreaAsks) {
  std::size_t near_poles = 0;
  for (const Vector3& point : sample(sphere))
    near_poles += std::abs(point.z - region_centre.z) > 0.9 * sphere.radius;
  const double share = static_cast<double>(near_poles) / static_cast<double>(many);
  EXPECT_NEAR(share, 0.1, 5.0 * std::sqrt(0.09 / static_cast<double>(many)));
}

TEST(AttractionRegion, IsAFunctionOfItsStream) {
  for (const RoundRegion& region : {disc, annulus, ring, shell}) {
    EXPECT_EQ(sample(region, 7, 50), sample(region, 7, 50));
    EXPECT_NE(sample(region, 7, 50), sample(region, 8, 50));
    const auto more = sample(region, 7, 60);
    EXPECT_EQ(sample(region, 7, 50), std::vector<Vector3>(more.begin(), more.begin() + 50));
  }
}

TEST(AttractionRegion, MayHaveNoPoints) {
  EXPECT_TRUE(sample(disc, 1, 0).empty());
}

TEST(AttractionRegion, RefusesRadiiThatMakeNoSense) {
  for (const auto& [radius, inner] : {std::pair{0.0, 0.0}, {-1.0, 0.0}, {1.0, 2.0}, {1.0, -0.5}})
    EXPECT_THROW(sample({RoundShape::annulus, radius, inner, {}}, 1, 1), ContractViolation);
}

}  // namespace
}  // namespace phytobench
