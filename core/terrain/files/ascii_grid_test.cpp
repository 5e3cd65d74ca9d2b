// SPDX-License-Identifier: MIT
#include "core/terrain/files/ascii_grid.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string small_header =
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9999\n";

Raster grid_of(std::string_view text, const std::string& projection = "") {
  return parse_ascii_grid(text, "hill.asc", projection);
}

std::string grid_error(const std::string& text) {
  return input_error_of([&] { grid_of(text); });
}

TEST(AsciiGrid, GivesNumbersFromTheNorthAndTheirPlace) {
  const Raster raster = grid_of(small_header + "1 2 3\n4 5.5 -6e1\n");
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 2);
  EXPECT_THAT(raster.values, ElementsAre(1.0, 2.0, 3.0, 4.0, 5.5, -60.0));
  ASSERT_TRUE(raster.place);
  EXPECT_EQ(raster.place->west, 100.0);
  EXPECT_EQ(raster.place->north, 220.0);
  EXPECT_EQ(raster.place->column_step, 10.0);
  EXPECT_EQ(raster.place->row_step, -10.0);
  EXPECT_EQ(raster.format, "ESRI ASCII grid");
}

TEST(AsciiGrid, TakesEntriesInAnyOrderCaseAndLayout) {
  const Raster raster = grid_of(
      "NROWS\t2\r\n\r\n  YLLCENTER 205\r\nnCols   3\r\nXLLCENTER 105\r\nDY 10\r\ndx 10\r\n"
      "  1\t2  3\r\n\r\n4 5 +6");
  EXPECT_THAT(raster.values, ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_EQ(raster.place->west, 100.0);
  EXPECT_EQ(raster.place->north, 220.0);
}

TEST(AsciiGrid, CellsNeedNotBeSquare) {
  const Raster raster = grid_of("ncols 1\nnrows 2\nxllcorner 0\nyllcorner 0\ndx 30\ndy 40\n7\n8\n");
  EXPECT_EQ(raster.place->column_step, 30.0);
  EXPECT_EQ(raster.place->row_step, -40.0);
  EXPECT_EQ(raster.place->north, 80.0);
}

TEST(AsciiGrid, WithoutACellSizeThereIsNoPlace) {
  EXPECT_FALSE(grid_of("ncols 1\nnrows 1\n7\n").place);
}

TEST(AsciiGrid, MarksWhatHasNoData) {
  const Raster raster = grid_of(small_header + "1 -9999 3\n-9999.0 5 6\n");
  EXPECT_TRUE(std::isnan(raster.values[1]));
  EXPECT_TRUE(std::isnan(raster.values[3]));
  EXPECT_EQ(raster.values[5], 6.0);
  const Raster by_nan = grid_of("ncols 2\nnrows 1\nnodata_value nan\nnan 5\n");
  EXPECT_TRUE(std::isnan(by_nan.values[0]));
  EXPECT_EQ(by_nan.values[1], 5.0);
}

TEST(AsciiGrid, WithoutAMarkItIsTheOneOfTheFormat) {
  const Raster usual = grid_of("ncols 3\nnrows 1\n-9999 -9999.0 -9998\n");
  EXPECT_TRUE(std::isnan(usual.values[0]));
  EXPECT_TRUE(std::isnan(usual.values[1]));
  EXPECT_EQ(usual.values[2], -9998.0);
  // One that is given stands instead.
  EXPECT_EQ(grid_of("ncols 2\nnrows 1\nNODATA_value 0\n-9999 5\n").values[0], -9999.0);
}

TEST(AsciiGrid, RowsMayBeBrokenWhereTheFirstIs) {
  EXPECT_THAT(grid_of(small_header + "1 2\n3 4\n5 6\n").values,
              ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_THAT(grid_of(small_header + "1 2 3 4 5 6").values,
              ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
}

TEST(AsciiGrid, RefusesWrongCountsWithTheirLine) {
  EXPECT_EQ(grid_error(small_header + "10 20 30\n4 5\n"),
            "hill.asc:8: 2 numbers where ncols says 3; complete the row or is the file cut off?");
  EXPECT_THAT(grid_error(small_header + "1 2 3\n4 5 6 7\n"),
              StartsWith("hill.asc:8: more numbers"));
  EXPECT_THAT(grid_error(small_header + "1 2 3\n4 5 6\n7 8 9\n"),
              StartsWith("hill.asc:9: more numbers than 3 x 2 = 6"));
  EXPECT_EQ(grid_error(small_header + "100 200\n300 400\n500\n"),
            "hill.asc:9: the file ends after 5 of 3 x 2 = 6 numbers; is it cut off?");
  EXPECT_THAT(grid_error(small_header + "1 2 3\n"),
              StartsWith("hill.asc:7: the file ends after 3"));
  EXPECT_THAT(grid_error(small_header), HasSubstr("has a header but no numbers"));
  EXPECT_THAT(grid_error(""), HasSubstr("no numbers"));
}

// Nothing is allocated for a size that the file cannot hold.
TEST(AsciiGrid, RefusesSizesThatAreNone) {
  EXPECT_THAT(grid_error("ncols 0\nnrows 2\n1\n"),
              StartsWith("hill.asc:1: ncols = 0 is no number"));
  EXPECT_THAT(grid_error("ncols 2\nnrows -2\n1\n"), StartsWith("hill.asc:2: nrows = -2"));
  EXPECT_THAT(grid_error("ncols 2.5\nnrows 2\n1\n"), HasSubstr("ncols = 2.5"));
  EXPECT_THAT(grid_error("ncols 1e300\nnrows 2\n1\n"), HasSubstr("ncols = 1e+300"));
  EXPECT_THAT(grid_error("ncols 20000\nnrows 20000\n1\n"),
              HasSubstr("20000 x 20000 vertices are more than the 268435456 that fit"));
  EXPECT_THAT(grid_error("ncols 16384\nnrows 16384\n1 2\n"),
              HasSubstr("ends after 2 of 16384 x 16384 = 268435456 numbers"));
  EXPECT_THAT(grid_error("nrows 2\n1\n"), HasSubstr("has no entry ncols"));
}

TEST(AsciiGrid, RefusesHeadersThatContradictThemselves) {
  const std::string sizes = "ncols 1\nnrows 1\n";
  EXPECT_THAT(grid_error(sizes + "ncols 2\n1\n"), StartsWith("hill.asc:3: ncols is there twice"));
  EXPECT_THAT(grid_error(sizes + "cellsize 0\n1\n"), StartsWith("hill.asc:3: cellsize = 0"));
  EXPECT_THAT(grid_error(sizes + "cellsize nan\n1\n"), HasSubstr("cellsize needs one number"));
  EXPECT_THAT(grid_error(sizes + "cellsize\n1\n"), HasSubstr("cellsize needs one number, not ''"));
  EXPECT_THAT(grid_error(sizes + "cellsize 1 2\n1\n"), HasSubstr("cellsize needs one number"));
  EXPECT_THAT(grid_error(sizes + "dx 3\n1\n"), StartsWith("hill.asc:3: dx and dy need each other"));
  EXPECT_THAT(grid_error(sizes + "dx 3\ndy 4\ncellsize 2\n1\n"),
              StartsWith("hill.asc:5: cellsize stands beside"));
  EXPECT_THAT(grid_error(sizes + "cellsize 1\nxllcorner 1\nxllcenter 1\n1\n"),
              HasSubstr("xllcenter stands beside xllcorner"));
  EXPECT_THAT(grid_error(sizes + "cellsize 1\nxllcorner 1\nyllcenter 1\n1\n"),
              HasSubstr("keep to one"));
  EXPECT_THAT(grid_error(sizes + "colour 3\n1\n"), StartsWith("hill.asc:3: 'colour' is no entry"));
  EXPECT_THAT(grid_error("P5 1 1 255\n"), StartsWith("hill.asc:1: 'p5' is no entry"));
}

TEST(AsciiGrid, RefusesWordsThatAreNoNumbers) {
  EXPECT_THAT(grid_error(small_header + "1 2 3\n4 high 6\n"),
              StartsWith("hill.asc:8: 'high' is no finite number"));
  EXPECT_THAT(grid_error(small_header + "1 nan 3\n4 5 6\n"), HasSubstr("hill.asc:7: 'nan'"));
  EXPECT_THAT(grid_error(small_header + "nan 2 3\n4 5 6\n"), HasSubstr("hill.asc:7: 'nan'"));
  EXPECT_THAT(grid_error(small_header + "1 inf 3\n4 5 6\n"), HasSubstr("hill.asc:7: 'inf'"));
  EXPECT_THAT(grid_error(small_header + "1 1e999 3\n4 5 6\n"), HasSubstr("'1e999'"));
  EXPECT_THAT(grid_error(small_header + "1,5 2 3\n4 5 6\n"), HasSubstr("'1,5'"));
  EXPECT_THAT(grid_error(small_header + "1 2 3\n4 5 6\x01\n"), HasSubstr("'6?'"));
}

TEST(AsciiGrid, TakesItsUnitFromTheProjection) {
  const std::string text = small_header + "1 2 3\n4 5 6\n";
  EXPECT_EQ(grid_of(text).unit.kind, CoordinateUnit::Kind::not_said);
  const Raster raster = grid_of(text, "GEOGCS[\"WGS 84\"]");
  EXPECT_EQ(raster.unit.kind, CoordinateUnit::Kind::degrees);
  EXPECT_EQ(raster.place->projection, "GEOGCS[\"WGS 84\"]");
}

}  // namespace
}  // namespace phytobench
