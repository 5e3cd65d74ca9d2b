// SPDX-License-Identifier: MIT
#include "core/terrain/files/map_files.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/grey_image.hpp"
#include "core/random/counter_stream.hpp"
#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class MapFiles : public TestFolder {};

constexpr double gap = HeightField::no_data;

HeightField map_of(int columns, int rows, const std::vector<double>& values) {
  HeightField field(columns, rows, 30.0, 40.0);
  std::copy(values.begin(), values.end(), field.heights().begin());
  return field;
}

MapView view_of(const HeightField& field, const std::optional<GeoReference>& place = {}) {
  return map_view(field, field.heights(), place);
}

/// Random numbers of many sizes, and gaps.
HeightField random_map(int columns, int rows) {
  CounterStream numbers(4, 0);
  HeightField field(columns, rows, 30.0, 40.0);
  for (double& height : field.heights()) {
    const double scale = std::pow(10.0, std::floor(numbers.next_between(-12.0, 6.0)));
    height = numbers.next_unit() < 0.1 ? gap : numbers.next_between(-1.0, 1.0) * scale;
  }
  return field;
}

void expect_equal_bits(const HeightField& read, const HeightField& truth) {
  ASSERT_EQ(read.columns(), truth.columns());
  ASSERT_EQ(read.rows(), truth.rows());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double a = read.heights()[i], b = truth.heights()[i];
    if (std::isnan(b))
      EXPECT_TRUE(std::isnan(a)) << i;
    else
      EXPECT_EQ(a, b) << i;
  }
}

void write_map_files(const fs::path& file, const MapView& map) {
  write_files_atomically(map_files(file, map));
}

TEST_F(MapFiles, TextComesBackExactly) {
  const HeightField truth = random_map(37, 23);
  write_map_files(folder_ / "map.asc", view_of(truth));
  const HeightFile grid = read_height_file(folder_ / "map.asc", {});
  expect_equal_bits(grid.field, truth);
  EXPECT_EQ(grid.field.cell_width(), 30.0);
  EXPECT_EQ(grid.field.cell_depth(), 40.0);
  write_map_files(folder_ / "map.csv", view_of(truth));
  expect_equal_bits(read_height_file(folder_ / "map.csv", {.cell_width = 1.0}).field, truth);
}

TEST_F(MapFiles, AsciiGridsKeepTheirPlaceAndProjection) {
  const GeoReference place{.west = 500.0,
                           .north = 900.0,
                           .column_step = 25.0,
                           .row_step = -25.0,
                           .projection = "PROJCS[\"x\",UNIT[\"Meter\",1]]"};
  const HeightField truth = map_of(2, 3, {1, 2, gap, 4, 5, 6});
  EXPECT_EQ(to_ascii_grid(view_of(truth, place)),
            "ncols 2\nnrows 3\nxllcorner 500\nyllcorner 825\ncellsize 25\nNODATA_value -9999\n"
            "1 2\n-9999 4\n5 6\n");
  write_map_files(folder_ / "map.asc", view_of(truth, place));
  const HeightFile read = read_height_file(folder_ / "map.asc", {});
  EXPECT_EQ(read.place->west, 500.0);
  EXPECT_EQ(read.place->north, 900.0);
  EXPECT_EQ(read.place->projection, place.projection);
  EXPECT_EQ(read_text_file(folder_ / "map.prj"), place.projection);
}

TEST_F(MapFiles, TheMarkForNoDataIsNoNumberOfTheMap) {
  const HeightField truth = map_of(2, 2, {-9999.0, gap, -99999.0, 1.0});
  EXPECT_THAT(to_ascii_grid(view_of(truth)), HasSubstr("NODATA_value -999999\n"));
  write_map_files(folder_ / "map.asc", view_of(truth));
  expect_equal_bits(read_height_file(folder_ / "map.asc", {}).field, truth);
}

TEST_F(MapFiles, NumberRowsHaveNanWhereThereIsNoData) {
  EXPECT_EQ(to_number_rows(view_of(map_of(2, 2, {0.1, gap, -3.0, 1e-7}))), "0.1,nan\n-3,1e-07\n");
}

TEST_F(MapFiles, GreyLevelsAreRounded) {
  const HeightField truth = map_of(3, 1, {0.0, 0.1249, 8191.875});
  const GreyImage image = parse_grey_png(to_grey_png(view_of(truth), {.step = 0.125}), "x");
  EXPECT_EQ(image.bits, 16);
  EXPECT_THAT(image.levels, ElementsAre(0, 1, 65535));
  const HeightField with_gap = map_of(2, 1, {3.0, gap});
  EXPECT_THAT(parse_grey_png(to_grey_png(view_of(with_gap), {.no_data_level = 999}), "x").levels,
              ElementsAre(3, 999));
  const HeightField below = map_of(1, 1, {-0.4});
  EXPECT_THAT(parse_grey_png(to_grey_png(view_of(below), {}), "x").levels, ElementsAre(0));
}

// [Lesser2019] listing 9.8 lets such numbers wrap around: 150 cm come back as 18.928 cm.
TEST_F(MapFiles, NumbersWithoutAGreyLevelAreRefused) {
  const auto error = [](const std::vector<double>& values, const GreyScale& scale) {
    const HeightField map = map_of(static_cast<int>(values.size()), 1, values);
    return input_error_of([&] { to_grey_png(view_of(map), scale); });
  };
  EXPECT_THAT(error({150.0, 131.07}, {.step = 0.001}),
              HasSubstr("150 is beyond level 65535 at 0.001 a level; take at least 0.00228"));
  EXPECT_THAT(error({-1.0}, {}), HasSubstr("-1 is below 0"));
  EXPECT_THAT(error({gap}, {}), HasSubstr("vertices without data"));
  EXPECT_THAT(error({std::numeric_limits<double>::infinity()}, {}), HasSubstr("inf is beyond"));
}

TEST_F(MapFiles, TheEndingSaysTheFormat) {
  EXPECT_EQ(map_format("a.TIF"), MapFormat::geotiff);
  EXPECT_EQ(map_format("a.tiff"), MapFormat::geotiff);
  EXPECT_EQ(map_format("a.b.asc"), MapFormat::ascii_grid);
  EXPECT_EQ(map_format("a.csv"), MapFormat::csv);
  EXPECT_EQ(map_format("a.Png"), MapFormat::png);
  for (const char* name : {"a", "a.jpg", "tif"})
    EXPECT_THAT(input_error_of([&] { map_format(name); }), HasSubstr("end the name in .tif"));
}

TEST_F(MapFiles, AMapAndItsNumbersMustFit) {
  const HeightField field = map_of(2, 1, {1.0, 2.0});
  const std::vector<double> numbers(3);
  EXPECT_THROW(map_view(field, numbers, {}), ContractViolation);
  EXPECT_THROW(to_ascii_grid({.columns = 2, .rows = 2, .values = field.heights()}),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
