// SPDX-License-Identifier: MIT
#include "core/terrain/files/coordinate_unit.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using Unit = CoordinateUnit::Kind;

// Kilometres of a degree on the WGS 84 ellipsoid, as tables of geodesy print them.
TEST(DegreeLength, AgreesWithPrintedTables) {
  struct Line {
    double latitude, north_km, east_km;
  };
  constexpr Line table[] = {{0, 110.574, 111.320}, {15, 110.649, 107.550}, {30, 110.852, 96.486},
                            {45, 111.132, 78.847}, {60, 111.412, 55.800},  {75, 111.618, 28.902},
                            {90, 111.694, 0.000}};
  // Printed to the metre; at 15 degrees tables disagree in the last digit.
  constexpr double printed_m = 1.0;
  for (const Line& line : table)
    for (const double sign : {1.0, -1.0}) {
      const DegreeLength degree = degree_length(sign * line.latitude);
      EXPECT_NEAR(degree.north, 1000.0 * line.north_km, printed_m) << line.latitude;
      EXPECT_NEAR(degree.east, 1000.0 * line.east_km, printed_m) << line.latitude;
    }
}

TEST(UnitOfProjection, ReadsWellKnownTextOfBothVersions) {
  EXPECT_EQ(unit_of_projection("").kind, Unit::not_said);
  EXPECT_EQ(unit_of_projection("LOCAL_CS[\"x\"]").kind, Unit::not_said);
  EXPECT_EQ(unit_of_projection("\n GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925199433]]").kind,
            Unit::degrees);
  EXPECT_EQ(unit_of_projection("GEOGCRS[\"WGS 84\"]").kind, Unit::degrees);
  EXPECT_EQ(unit_of_projection("Projection    GEOGRAPHIC\nUnits  DD\n").kind, Unit::degrees);
  EXPECT_EQ(unit_of_projection("Projection    UTM\nUnits METERS\n").kind, Unit::lengths);
  const CoordinateUnit metres = unit_of_projection(
      "PROJCS[\"UTM 33\",GEOGCS[\"WGS 84\",UNIT[\"Degree\",0.017453292519943295]],"
      "UNIT[\"Meter\",1]]");
  EXPECT_EQ(metres.kind, Unit::lengths);
  EXPECT_EQ(metres.metres, 1.0);
  const CoordinateUnit feet = unit_of_projection(
      "PROJCRS[\"x\",BASEGEOGCRS[\"y\",ANGLEUNIT[\"degree\",0.0174532925199433]],"
      "LENGTHUNIT[\"US survey foot\", 0.304800609601219]]");
  EXPECT_EQ(feet.kind, Unit::lengths);
  EXPECT_EQ(feet.metres, 0.304800609601219);
  EXPECT_EQ(unit_of_projection("PROJCS[\"x\",UNIT[\"broken").metres, 1.0);
}

TEST(LikelyUnit, TakesNarrowCellsOnTheGlobeForDegrees) {
  const GeoReference tile{
      .west = -84.4, .north = 36.7, .column_step = 1.0 / 1200, .row_step = -1.0 / 1200};
  EXPECT_EQ(likely_unit(tile, 400, 300).kind, Unit::degrees);
  GeoReference local = tile;
  local.column_step = 0.5;
  EXPECT_EQ(likely_unit(local, 400, 300).kind, Unit::lengths) << "half a metre";
  local = tile;
  local.north = 5000000.0;
  EXPECT_EQ(likely_unit(local, 400, 300).kind, Unit::lengths);
  const GeoReference drone{.west = 0.0, .north = 20.0, .column_step = 0.05, .row_step = -0.05};
  EXPECT_EQ(likely_unit(drone, 400, 400).kind, Unit::lengths) << "begins at (0, 0)";
}

Raster raster_at(double north, double step, Unit unit, double metres = 1.0) {
  Raster raster;
  raster.columns = 10;
  raster.rows = 20;
  raster.place =
      GeoReference{.west = 10.0, .north = north, .column_step = step, .row_step = -2.0 * step};
  raster.unit = {unit, metres};
  return raster;
}

TEST(CellSizeOfAMap, TurnsDegreesIntoMetresInTheMiddle) {
  const CellSize cell = cell_size(raster_at(45.2, 0.01, Unit::degrees), {}, "x");
  const DegreeLength degree = degree_length(45.0);
  EXPECT_NEAR(cell.width, 0.01 * degree.east, 1e-9);
  EXPECT_NEAR(cell.depth, 0.02 * degree.north, 1e-9);
  const CellSize feet = cell_size(raster_at(45.2, 10.0, Unit::lengths, 0.3048), {}, "x");
  EXPECT_NEAR(feet.width, 3.048, 1e-12);
  EXPECT_NEAR(feet.depth, 6.096, 1e-12);
  const CellSize likely = cell_size(raster_at(45.2, 0.01, Unit::not_said), {}, "x");
  EXPECT_EQ(likely.width, cell.width);
}

TEST(CellSizeOfAMap, OptionsComeFirst) {
  const HeightFileOptions both{.cell_width = 3.0, .cell_depth = 4.0};
  const CellSize cell = cell_size(raster_at(45.2, 0.01, Unit::degrees), both, "x");
  EXPECT_EQ(cell.width, 3.0);
  EXPECT_EQ(cell.depth, 4.0);
  Raster without_place;
  without_place.columns = without_place.rows = 2;
  EXPECT_EQ(cell_size(without_place, {.cell_width = 3.0}, "x").depth, 3.0);
  EXPECT_EQ(cell_size(without_place, {.cell_depth = 5.0}, "x").width, 5.0);
}

std::string cell_error(const Raster& raster, const HeightFileOptions& options) {
  return input_error_of([&] { cell_size(raster, options, "hill.tif"); });
}

TEST(CellSizeOfAMap, RefusesWhatIsMissingMixedOrNone) {
  const Raster placed = raster_at(45.2, 0.01, Unit::degrees);
  Raster without_place;
  without_place.columns = without_place.rows = 2;
  EXPECT_THAT(cell_error(without_place, {}), HasSubstr("hill.tif: does not say how wide"));
  // One in metres from the user, the other in degrees from the file.
  EXPECT_THAT(cell_error(placed, {.cell_width = 3.0}), HasSubstr("give both or none"));
  EXPECT_THAT(cell_error(placed, {.cell_depth = 3.0}), HasSubstr("give both or none"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double size : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THAT(cell_error(placed, {.cell_width = size, .cell_depth = 1.0}),
                HasSubstr("is no length"));
  EXPECT_THAT(cell_error(raster_at(500.0, 1.0, Unit::degrees), {}), HasSubstr("beyond the pole"));
}

}  // namespace
}  // namespace phytobench
