// SPDX-License-Identifier: MIT
#include "core/terrain/relief.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

constexpr std::array estimators = {SurfaceEstimator::sobel, SurfaceEstimator::six_faces,
                                   SurfaceEstimator::other_six, SurfaceEstimator::unit_faces};
constexpr double degrees = 180.0 / std::numbers::pi;

/// Heights of a function of metres east and south of the first vertex.
HeightField sampled(int columns, int rows, double width, double depth,
                    const std::function<double(double, double)>& height) {
  HeightField field(columns, rows, width, depth);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      field.at(column, row) = height(column * width, row * depth);
  return field;
}

TEST(Relief, FlatGroundLooksUp) {  // [Lesser2019] eq. 8.2
  const HeightField field(3, 3, 16.0, 16.0, 7.0);
  for (const SurfaceEstimator estimator : estimators) {
    const Vector3 normal = surface_normal(surface_gradient(field, 1, 1, estimator));
    EXPECT_EQ(std::abs(normal.x), 0.0);
    EXPECT_EQ(std::abs(normal.y), 0.0);
    EXPECT_EQ(normal.z, 1.0);
  }
}

// [Lesser2019] sec. 8.3 gives two ways; on planes both are exact, at the border, too.
TEST(Relief, APlaneHasItsSlopeEverywhere) {
  struct Plane {
    double east, south, slope;
  };
  for (const Plane& plane :
       {Plane{1.0, 0.0, 45.0}, Plane{0.0, std::sqrt(3.0), 60.0}, Plane{0.3, -0.7, 37.2920757}}) {
    const HeightField field = sampled(
        4, 5, 16.0, 9.0, [&](double x, double y) { return plane.east * x + plane.south * y; });
    for (const SurfaceEstimator estimator : estimators)
      for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 4; ++column) {
          const SurfaceGradient gradient = surface_gradient(field, column, row, estimator);
          EXPECT_NEAR(gradient.east, plane.east, 1e-12);
          EXPECT_NEAR(gradient.south, plane.south, 1e-12);
          EXPECT_NEAR(slope_degrees(gradient), plane.slope, 1e-7);
        }
  }
}

TEST(Relief, OneRowKnowsNothingOfTheOther) {
  const HeightField field = sampled(5, 1, 2.0, 2.0, [](double x, double) { return x; });
  const SurfaceGradient gradient = surface_gradient(field, 2, 0);
  EXPECT_EQ(gradient.east, 1.0);
  EXPECT_TRUE(std::isnan(gradient.south) || gradient.south == 0.0);
}

// Area-weighted faces, written out: the centre does not matter.
TEST(Relief, SixFacesHaveTheirClosedForm) {
  HeightField field(3, 3, 16.0, 16.0);
  const std::array<double, 9> heights = {3, 1, 4, 1, 5, 9, 2, 6, 5};
  for (std::size_t i = 0; i < 9; ++i) field.heights()[i] = heights[i];
  const auto h = [&](int column, int row) { return field.at(1 + column, 1 + row); };
  const double east =
      (2 * (h(1, 0) - h(-1, 0)) + (h(1, -1) - h(0, -1)) + (h(0, 1) - h(-1, 1))) / 96;
  const double south =
      (2 * (h(0, 1) - h(0, -1)) + (h(1, 0) - h(1, -1)) + (h(-1, 1) - h(-1, 0))) / 96;
  const SurfaceGradient before = surface_gradient(field, 1, 1, SurfaceEstimator::six_faces);
  EXPECT_NEAR(before.east, east, 1e-14);
  EXPECT_NEAR(before.south, south, 1e-14);
  field.at(1, 1) += 1000.0;
  const SurfaceGradient after = surface_gradient(field, 1, 1, SurfaceEstimator::six_faces);
  EXPECT_NEAR(after.east, east, 1e-12);
  EXPECT_NEAR(after.south, south, 1e-12);
}

TEST(Relief, ACreaseTellsTheWeightsApart) {
  const HeightField field =
      sampled(3, 3, 16.0, 16.0, [](double x, double) { return std::max(x - 16.0, 0.0); });
  EXPECT_NEAR(slope_degrees(surface_gradient(field, 1, 1, SurfaceEstimator::sobel)), 26.565051,
              1e-6);
  EXPECT_NEAR(slope_degrees(surface_gradient(field, 1, 1, SurfaceEstimator::six_faces)), 26.565051,
              1e-6);
  EXPECT_NEAR(slope_degrees(surface_gradient(field, 1, 1, SurfaceEstimator::unit_faces)), 22.5,
              1e-9);
}

/// The error of the slope at (0.7, 0.4) of a smooth surface, cells of that size.
double slope_error(double cell, SurfaceEstimator estimator) {
  const HeightField field = sampled(3, 3, cell, cell, [cell](double dx, double dy) {
    const double x = 0.7 - cell + dx, y = 0.4 - cell + dy;
    return std::sin(x) * std::cos(y) + 0.1 * x * x * x + 0.05 * x * x * y;
  });
  const double east = std::cos(0.7) * std::cos(0.4) + 0.3 * 0.49 + 0.1 * 0.7 * 0.4;
  const double south = -std::sin(0.7) * std::sin(0.4) + 0.05 * 0.49;
  return slope_degrees(surface_gradient(field, 1, 1, estimator)) -
         std::atan(std::hypot(east, south)) * degrees;
}

TEST(ReliefLaw, ErrorsFallWithTheSquareOfTheCell) {
  for (const SurfaceEstimator estimator : estimators)
    for (const double cell : {0.2, 0.1, 0.05}) {
      const double order =
          std::log2(slope_error(cell, estimator) / slope_error(cell / 2.0, estimator));
      EXPECT_NEAR(order, 2.0, 0.03) << static_cast<int>(estimator) << " " << cell;
    }
}

TEST(ReliefLaw, MirrorsAndTurns) {
  const HeightField field = sampled(
      5, 5, 3.0, 3.0, [](double x, double y) { return std::sin(x) + std::cos(0.3 * x * y); });
  const HeightField turned = transposed(field);
  for (const SurfaceEstimator estimator : {SurfaceEstimator::sobel, SurfaceEstimator::six_faces}) {
    const SurfaceGradient here = surface_gradient(field, 1, 3, estimator);
    const SurfaceGradient there = surface_gradient(turned, 3, 1, estimator);
    EXPECT_NEAR(here.east, there.south, 1e-14);
    EXPECT_NEAR(here.south, there.east, 1e-14);
  }
}

TEST(Relief, HolesAreLeftOut) {
  HeightField field = sampled(5, 5, 1.0, 1.0, [](double x, double y) { return 2.0 * x - y; });
  field.at(3, 1) = HeightField::no_data;
  for (const SurfaceEstimator estimator : estimators) {
    const SurfaceGradient beside = surface_gradient(field, 2, 2, estimator);
    EXPECT_NEAR(beside.east, 2.0, 1e-12);
    EXPECT_NEAR(beside.south, -1.0, 1e-12);
    EXPECT_TRUE(std::isnan(surface_gradient(field, 3, 1, estimator).east));
  }
}

}  // namespace
}  // namespace phytobench
