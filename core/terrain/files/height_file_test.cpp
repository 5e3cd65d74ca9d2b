// SPDX-License-Identifier: MIT
#include "core/terrain/files/height_file.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/grey_image.hpp"
#include "core/picture/image.hpp"
#include "core/terrain/files/coordinate_unit.hpp"
#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class HeightFileTest : public TestFolder {};
class NumberMapTest : public TestFolder {};

constexpr HeightFileOptions square{.cell_width = 16.0, .cell_depth = 16.0};

std::string reading_error(const fs::path& file, const HeightFileOptions& options = square) {
  return input_error_of([&] { read_height_file(file, options); });
}

const std::string small_grid =
    "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 25\nNODATA_value -1\n1 2\n-1 4\n";

TEST_F(HeightFileTest, ReadsAnAsciiGridWhateverItIsCalled) {
  for (const char* name : {"hill.asc", "HILL.ASC", "hill.txt"}) {
    const HeightFile file = read_height_file(written(name, small_grid), {});
    EXPECT_EQ(file.field.columns(), 2);
    EXPECT_EQ(file.field.cell_width(), 25.0);
    EXPECT_EQ(file.field.at(1, 0), 2.0);
    EXPECT_FALSE(file.field.has_data(0, 1));
    EXPECT_EQ(file.format, "ESRI ASCII grid");
    ASSERT_TRUE(file.place);
    EXPECT_EQ(file.place->west, 1000.0);
    EXPECT_EQ(file.place->north, 2050.0);
  }
}

TEST_F(HeightFileTest, ConvertsHeightsOnceAndKeepsNoData) {
  const HeightFile file =
      read_height_file(written("hill.asc", small_grid), {.height_conversion = 0.1});
  EXPECT_DOUBLE_EQ(file.field.at(1, 1), 0.4);
  EXPECT_FALSE(file.field.has_data(0, 1));
}

TEST_F(HeightFileTest, LooksForTheProjectionBesideTheGrid) {
  const fs::path file = written("hill.asc", small_grid);
  written("hill.prj", "PROJCS[\"x\",UNIT[\"foot\",0.3048]]");
  const HeightFile read = read_height_file(file, {});
  EXPECT_DOUBLE_EQ(read.field.cell_width(), 25.0 * 0.3048);
  EXPECT_EQ(read.place->column_step, 25.0) << "a place stays in its own unit";
  EXPECT_THAT(read.place->projection, HasSubstr("PROJCS"));
}

// 3 seconds of arc, as digital elevation models come: not square in metres.
TEST_F(HeightFileTest, DegreesMakeCellsThatAreNotSquare) {
  const HeightFile file =
      read_height_file(written("hill.asc",
                               "ncols 2\nnrows 2\nxllcorner -84.4\nyllcorner 36.5\n"
                               "cellsize 0.000833333333\n1 2\n3 4\n"),
                       {});
  const DegreeLength degree = degree_length(36.5 + 0.000833333333);
  EXPECT_NEAR(file.field.cell_width(), degree.east / 1200.0, 1e-6);
  EXPECT_NEAR(file.field.cell_depth(), degree.north / 1200.0, 1e-6);
  EXPECT_LT(file.field.cell_width(), 0.82 * file.field.cell_depth());
}

TEST_F(HeightFileTest, ReadsGreyPictures) {
  const GreyImage image{.width = 2, .height = 3, .bits = 16, .levels = {0, 1, 256, 4000, 65535, 7}};
  const HeightFileOptions options{.height_conversion = 0.1, .cell_width = 16.0, .cell_depth = 20.0};
  for (const char* name : {"hill.png", "hill.dat"}) {
    const HeightFile file = read_height_file(written(name, to_png(image)), options);
    EXPECT_EQ(file.format, "PNG");
    EXPECT_EQ(file.field.columns(), 2);
    EXPECT_EQ(file.field.rows(), 3);
    EXPECT_EQ(file.field.cell_depth(), 20.0);
    EXPECT_DOUBLE_EQ(file.field.at(1, 1), 400.0);
    EXPECT_DOUBLE_EQ(file.field.at(0, 2), 6553.5);
    EXPECT_EQ(file.field.at(0, 0), 0.0) << "black is a height, not the lack of one";
  }
  const GreyImage eight{.width = 1, .height = 1, .bits = 8, .levels = {255}};
  EXPECT_EQ(read_height_file(written("eight.png", to_png(eight)), square).field.at(0, 0), 255.0);
}

TEST_F(HeightFileTest, ReadsRowsOfNumbers) {
  const HeightFile file = read_height_file(written("hill.csv", "1,2,nan\n4,5,6\n"), square);
  EXPECT_EQ(file.format, "CSV");
  EXPECT_EQ(file.field.at(2, 1), 6.0);
  EXPECT_FALSE(file.field.has_data(2, 0));
  EXPECT_FALSE(file.place);
}

TEST_F(HeightFileTest, ALineOfVerticesIsAMap) {
  const HeightFile row = read_height_file(written("row.csv", "1,2,3\n"), square);
  EXPECT_EQ(row.field.rows(), 1);
  const HeightFile column = read_height_file(written("column.csv", "1\n2\n3\n"), square);
  EXPECT_EQ(column.field.columns(), 1);
  const HeightFile degrees = read_height_file(
      written("row.asc", "ncols 1\nnrows 3\nxllcorner 10\nyllcorner 50\ncellsize 0.001\n1\n2\n3\n"),
      {});
  EXPECT_GT(degrees.field.cell_width(), 70.0);
}

TEST_F(HeightFileTest, RefusesFilesThatAreNotThere) {
  EXPECT_THAT(reading_error(folder_ / "none.asc"), HasSubstr("none.asc: no such file"));
  EXPECT_THAT(reading_error(folder_), HasSubstr("is no plain file"));
}

TEST_F(HeightFileTest, RefusesMapsWithoutAnyHeight) {
  EXPECT_THAT(reading_error(written("a.csv", "nan,\n,nan\n")), HasSubstr("no vertex has data"));
  EXPECT_THAT(reading_error(written("a.asc", "ncols 2\nnrows 1\nNODATA_value 0\n0 0\n")),
              HasSubstr("a.asc: no vertex has data; is the mark for no data the right one?"));
}

TEST_F(HeightFileTest, RefusesHeightsThatCannotBe) {
  EXPECT_THAT(reading_error(written("a.csv", "1,2\n3,-3.4e38\n")),
              HasSubstr("a.csv: row 2, column 2: -3.4e+38 is no height in metres"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double conversion : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THAT(reading_error(written("b.csv", "1\n"), {.height_conversion = conversion}),
                HasSubstr("height_conversion"));
}

TEST_F(HeightFileTest, RefusesFilesWithoutACellSizeUnlessItIsGiven) {
  for (const fs::path& file :
       {written("a.csv", "1,2\n"), written("a.asc", "ncols 1\nnrows 1\n1\n"),
        written("a.png", to_png(GreyImage{.width = 1, .height = 1, .levels = {3}}))})
    EXPECT_THAT(reading_error(file, {}), HasSubstr("does not say how wide its cells are"));
  EXPECT_EQ(read_height_file(folder_ / "a.csv", {.cell_width = 3.0}).field.cell_depth(), 3.0);
  EXPECT_THAT(reading_error(written("b.asc", small_grid), {.cell_width = 3.0}),
              HasSubstr("give both or none"));
}

TEST_F(HeightFileTest, RefusesColouredPictures) {
  EXPECT_THAT(reading_error(written("a.png", to_png(Image(2, 2, {9, 9, 9, 255})))),
              HasSubstr("a.png: is a PNG of colours"));
  EXPECT_THAT(reading_error(written("b.png", "no picture")), HasSubstr("b.png: is no PNG"));
}

// As in a build without GDAL, or an installation whose module was left behind.
TEST_F(HeightFileTest, SaysWhatIsMissingForOtherFormats) {
  const fs::path file = written("hill.tif", "II*");
  ASSERT_EQ(::setenv("PHYTOBENCH_MODULES", folder_.c_str(), 1), 0);
  EXPECT_THAT(reading_error(file), HasSubstr("needs GDAL, which this build does not have; install "
                                             "libgdal-dev and build again, or use an ESRI ASCII"));
  written("phytobench_gdal.so", "no library");
  EXPECT_THAT(reading_error(file), HasSubstr("phytobench_gdal.so cannot be loaded ("));
  ::unsetenv("PHYTOBENCH_MODULES");
}

TEST_F(NumberMapTest, ReadsEveryFormatAndMarksNoData) {
  const NumberMap rows = read_number_map(written("soil.csv", "40,80\n,32767\n"));
  EXPECT_EQ(rows.columns, 2);
  EXPECT_EQ(rows.rows, 2);
  EXPECT_THAT(rows.numbers, ElementsAre(40, 80, -1, 32767));
  const GreyImage image{.width = 2, .height = 1, .bits = 8, .levels = {40, 255}};
  EXPECT_THAT(read_number_map(written("soil.png", to_png(image))).numbers, ElementsAre(40, 255));
  EXPECT_THAT(read_number_map(written("soil.asc", small_grid)).numbers, ElementsAre(1, 2, -1, 4));
}

TEST_F(NumberMapTest, RefusesWhatIsNoId) {
  const auto error = [&](const char* text) {
    return input_error_of([&] { read_number_map(written("soil.csv", text)); });
  };
  EXPECT_THAT(error("1,2\n3,4.5\n"),
              HasSubstr("soil.csv: row 2, column 2: 4.5 is no whole number from 0 to 32767"));
  EXPECT_THAT(error("-1\n"), HasSubstr("row 1, column 1: -1 is no"));
  EXPECT_THAT(error("32768\n"), HasSubstr("32768 is no"));
}

}  // namespace
}  // namespace phytobench
