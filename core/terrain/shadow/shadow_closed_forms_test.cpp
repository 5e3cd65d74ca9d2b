// SPDX-License-Identifier: MIT
// Shadows that can be computed by hand. The printed march and line_sweep take heights beside a ray
// for heights on it, and are left out where that matters: along slopes that they cross at an angle.
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/shadow/test_terrains.hpp"

namespace phytobench {
namespace {

using namespace testing_terrains;

constexpr double degree = std::numbers::pi / 180.0;

/// height(x, y) in metres from the middle of the map.
template <class Height>
HeightField around_middle(int vertices, double cell, const Height& height) {
  const int middle = vertices / 2;
  return made(vertices, vertices, cell, cell, 0, [&](int column, int row, double) {
    return height((column - middle) * cell, (row - middle) * cell);
  });
}

std::vector<const ShadowEngineDescriptor*> engines_of_surfaces() {
  std::vector<const ShadowEngineDescriptor*> engines;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines())
    if (engine->built() && engine->name != "printed_march" && engine->name != "line_sweep")
      engines.push_back(engine);
  return engines;
}

class ShadowClosedFormsOracle : public testing::TestWithParam<const ShadowEngineDescriptor*> {
 protected:
  LitMaps lit(const HeightField& field, double elevation, double azimuth) const {
    return lit_by(GetParam()->name, field, {direction_of({elevation, azimuth})});
  }
  /// Of the vertices where is(x, y), how many are dark.
  template <class Is>
  double dark(const LitMaps& maps, double cell, const Is& is) const {
    const int middle = maps.columns() / 2;
    int count = 0;
    for (int row = 0; row < maps.rows(); ++row)
      for (int column = 0; column < maps.columns(); ++column)
        count +=
            is((column - middle) * cell, (row - middle) * cell) && !maps.is_lit(0, column, row);
    return count;
  }
};

/// The wall of height h hides what is nearer than h / tan(elevation), and nothing else.
void expect_shadows_of_walls(std::string_view engine) {
  struct Wall {
    double cell, elevation;
    int dark_vertices;
  };
  for (const Wall& wall : {Wall{16, 30, 10}, {16, 15, 23}, {16, 45, 6}, {10, 30, 17}})
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
      const bool along_x = azimuth == 0.0 || azimuth == 180.0;
      const HeightField field = around_middle(101, wall.cell, [&](double x, double y) {
        return (along_x ? x : y) == 0.0 ? 100.0 : 0.0;
      });
      // Where the tangent of 45 degrees leaves a tie, an edge lit by rounding is none of ours.
      const LitMaps maps = lit_by(engine, field, {direction_of({wall.elevation + 1e-9, azimuth})});
      EXPECT_EQ(101 * 101 - maps.lit(0), 101u * static_cast<unsigned>(wall.dark_vertices))
          << "elevation " << wall.elevation << ", azimuth " << azimuth;
    }
}

TEST_P(ShadowClosedFormsOracle, ShadowOfAWallIsAsLongAsItsHeightOverTheTangent) {
  expect_shadows_of_walls(GetParam()->name);
}

TEST(LineSweepOracle, ShadowOfAWallIsAsLongAsItsHeightOverTheTangent) {
  expect_shadows_of_walls("line_sweep");
}

/// A slope is lit iff its tangent along the sun's azimuth is less than the sun's.
TEST_P(ShadowClosedFormsOracle, PlanesAreLitOneDegreeAboveTheirSlopeAndDarkOneDegreeBelow) {
  for (const double slope : {10.0, 30.0, 50.0})
    for (const double aside : {0.0, 17.0, 30.0, 45.0, 63.0})
      for (const double azimuth : {0.0, 58.0, 135.0, 201.0, 300.0}) {
        const SunDirection uphill = direction_of({0.0, azimuth + aside});
        const double rise = std::tan(slope * degree);
        const HeightField field = around_middle(41, 16.0, [&](double x, double y) {
          return rise * (x * uphill.east + y * uphill.south);
        });
        const double edge = std::atan(rise * std::cos(aside * degree)) / degree;
        EXPECT_EQ(lit(field, edge + 1.0, azimuth).lit(0), field.size());
        EXPECT_FALSE(lit(field, edge - 1.0, azimuth).is_lit(0, 20, 20));
        // A ray from the border leaves the map; a line between it and the next row is not on it.
        EXPECT_LE(lit(field, edge - 1.0, azimuth).lit(0), GetParam()->exact ? 81u : 160u);
      }
}

/// The profile of an infinite ridge is steeper for the sun by the sine of its azimuth.
TEST_P(ShadowClosedFormsOracle, RidgesShadeTheirNorthBelowTheProfileAngle) {
  const double slope = 40.0, azimuth = 60.0;  // an hour before noon, from the south
  const HeightField field = around_middle(
      81, 10.0, [&](double, double y) { return -std::abs(y) * std::tan(slope * degree); });
  const double edge = std::atan(std::tan(slope * degree) * std::sin(azimuth * degree)) / degree;
  for (const double off : {-1.0, 1.0}) {
    const LitMaps maps = lit(field, edge + off, azimuth);
    EXPECT_EQ(maps.is_lit(0, 30, 30), off > 0.0);
    EXPECT_TRUE(maps.is_lit(0, 30, 50));
  }
}

/// Half a cell on either side of a sector's two edges and of its arc may be counted wrongly.
TEST_P(ShadowClosedFormsOracle, ConesAreDarkInASector) {
  const double radius = 80.0, cell = 1.0;
  struct Cone {
    double slope, elevation;
  };
  for (const Cone& cone : {Cone{45, 30}, {60, 30}, {60, 45}})
    for (const double azimuth : {0.0, 70.0, 225.0}) {
      const double steepness = std::tan(cone.slope * degree);
      const HeightField field = around_middle(201, cell, [&](double x, double y) {
        return std::max(0.0, radius - std::hypot(x, y)) * steepness;
      });
      const LitMaps maps = lit(field, cone.elevation, azimuth);
      const double expected = std::acos(std::tan(cone.elevation * degree) / steepness);
      const double area = expected * radius * radius, edges = 2.0 * (1.0 + expected) * radius;
      EXPECT_NEAR(dark(maps, cell, [&](double x, double y) { return std::hypot(x, y) <= radius; }),
                  area, 0.5 * edges)
          << cone.slope << ", " << cone.elevation << ", azimuth " << azimuth;
    }
}

TEST_P(ShadowClosedFormsOracle, ConesOfLessSlopeThanTheSunAreLit) {
  const HeightField field = around_middle(
      101, 1.0, [](double x, double y) { return std::max(0.0, 40.0 - std::hypot(x, y)); });
  EXPECT_EQ(lit(field, 46.0, 20.0).lit(0), field.size());
}

/// A half ellipse of semi-axes r / sin(elevation) and r.
TEST_P(ShadowClosedFormsOracle, HemispheresCastHalfAnEllipse) {
  const double radius = 40.0;
  const HeightField field = around_middle(321, 1.0, [&](double x, double y) {
    return std::sqrt(std::max(0.0, radius * radius - x * x - y * y));
  });
  for (const double elevation : {15.0, 30.0, 45.0})
    for (const double azimuth : {0.0, 30.0, 45.0, 110.0}) {
      const LitMaps maps = lit(field, elevation, azimuth);
      const double sine = std::sin(elevation * degree);
      const double area = std::numbers::pi * radius * radius * (1.0 / sine - sine) / 2.0;
      // The ball is vertical where it meets the ground: half a cell too small all round.
      const double edge = std::numbers::pi * radius * (1.0 + 1.0 / sine) / 2.0;
      EXPECT_NEAR(dark(maps, 1.0, [](double, double) { return true; }), area, 0.75 * edge)
          << "elevation " << elevation << ", azimuth " << azimuth;
      const SunDirection away = direction_of({0.0, azimuth + 180.0});
      const auto along = [&](double distance) {
        return maps.is_lit(0, 160 + static_cast<int>(std::lround(distance * away.east)),
                           160 + static_cast<int>(std::lround(distance * away.south)));
      };
      EXPECT_FALSE(along(radius / sine - 4.0)) << elevation << ", " << azimuth;
      EXPECT_TRUE(along(radius / sine + 2.0)) << elevation << ", " << azimuth;
    }
}

std::string name_of_closed(const testing::TestParamInfo<const ShadowEngineDescriptor*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(All, ShadowClosedFormsOracle, testing::ValuesIn(engines_of_surfaces()),
                         name_of_closed);

}  // namespace
}  // namespace phytobench
