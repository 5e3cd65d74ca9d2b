// SPDX-License-Identifier: MIT
#include "core/terrain/made/resampled.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/made/analytic_terrains.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// Heights of which each says where it is.
HeightField numbered(int columns, int rows, double width, double depth) {
  HeightField field(columns, rows, width, depth);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) field.at(column, row) = 100.0 * row + column;
  return field;
}

TEST(OnSquareCells, PlanesStayWhatTheyAre) {
  const HeightField field = numbered(11, 7, 30.0, 45.0);
  const HeightField result = on_square_cells(field, 20.0);
  EXPECT_EQ(result.columns(), 16) << "300 m";
  EXPECT_EQ(result.rows(), 14) << "270 m, of which 260 hold whole cells";
  EXPECT_EQ(result.cell_width(), 20.0);
  EXPECT_EQ(result.cell_depth(), 20.0);
  for (int row = 0; row < result.rows(); ++row)
    for (int column = 0; column < result.columns(); ++column)
      EXPECT_NEAR(result.at(column, row), 100.0 * row * 20.0 / 45.0 + column * 20.0 / 30.0, 1e-10);
}

TEST(OnSquareCells, SquareCellsOfTheSameWidthChangeNothing) {
  for (const double cell : {1.0, 0.1, 92.46, 1.0 / 3.0}) {
    const HeightField field = numbered(1000, 3, cell, cell);
    const HeightField result = on_square_cells(field, cell);
    ASSERT_EQ(result.columns(), 1000) << cell;
    ASSERT_EQ(result.rows(), 3);
    for (std::size_t i = 0; i < field.size(); ++i)
      ASSERT_EQ(result.heights()[i], field.heights()[i]) << cell;
  }
}

TEST(OnSquareCells, LosesNoVertexToRoundingWhereCellsDivide) {
  // 0.1 is no binary number: 29 of its cells are 2.9000000000000004 wide.
  EXPECT_EQ(on_square_cells(numbered(30, 2, 0.3, 0.3), 0.1).columns(), 88);
  EXPECT_EQ(on_square_cells(numbered(88, 4, 0.1, 0.1), 0.3).columns(), 30);
}

TEST(OnSquareCells, NoDataSpreadsAsFarAsItHasAShare) {
  HeightField field = numbered(5, 5, 2.0, 2.0);
  field.at(2, 2) = HeightField::no_data;
  const HeightField result = on_square_cells(field, 1.0);
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column)
      EXPECT_EQ(result.has_data(column, row), std::abs(column - 4) > 1 || std::abs(row - 4) > 1)
          << column << ", " << row;
}

TEST(OnSquareCells, ASingleRowOrVertexIsEnough) {
  EXPECT_EQ(on_square_cells(numbered(1, 1, 5.0, 7.0), 3.0).size(), 1u);
  const HeightField line = on_square_cells(numbered(1, 4, 5.0, 6.0), 3.0);
  EXPECT_EQ(line.columns(), 1);
  EXPECT_EQ(line.rows(), 7);
  EXPECT_EQ(line.at(0, 1), 50.0);
}

template <class Call>
std::string resampling_error(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OnSquareCells, RefusesWhatIsTooLarge) {
  const HeightField field = numbered(101, 101, 100.0, 100.0);
  EXPECT_THAT(resampling_error([&] { on_square_cells(field, 0.1); }),
              HasSubstr("on cells of 0.1 m: 100001 x 100001 vertices are more than"));
  EXPECT_THAT(resampling_error([&] { on_square_cells(field, 1e-9); }),
              HasSubstr("1e-09 m make more"));
}

TEST(Cropped, TakesThePartAskedFor) {
  const HeightField field = numbered(10, 8, 3.0, 4.0);
  const HeightField part =
      cropped(field, {.first_column = 2, .first_row = 3, .columns = 4, .rows = 5});
  EXPECT_EQ(part.columns(), 4);
  EXPECT_EQ(part.rows(), 5);
  EXPECT_EQ(part.cell_depth(), 4.0);
  EXPECT_EQ(part.at(0, 0), 302.0);
  EXPECT_EQ(part.at(3, 4), 705.0);
}

TEST(Cropped, RefusesWhatIsNotOnTheMap) {
  const HeightField field = numbered(10, 8, 3.0, 4.0);
  for (const MapPart& part :
       {MapPart{.first_column = -1}, MapPart{.columns = 11}, MapPart{.first_row = 8},
        MapPart{.rows = 0}, MapPart{.first_column = 5, .columns = 6}, MapPart{.rows = 2147483647}})
    EXPECT_THAT(resampling_error([&] { cropped(field, part); }), HasSubstr("on a map of 10 x 8"));
}

TEST(Tiled, MirrorsWithoutSteps) {
  const HeightField field = numbered(3, 2, 1.0, 1.0);
  const HeightField result = tiled(field, 7, 4);
  const double expected[] = {0.0, 1.0, 2.0, 1.0, 0.0, 1.0, 2.0};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 7; ++column)
      EXPECT_EQ(result.at(column, row), expected[column] + (row % 2 == 1 ? 100.0 : 0.0));
  EXPECT_EQ(tiled(numbered(1, 1, 1.0, 1.0), 5, 6).at(4, 5), 0.0);
  EXPECT_THAT(resampling_error([&] { tiled(field, 1 << 20, 1 << 20); }),
              HasSubstr("a map of tiles"));
}

TEST(PlaceOfPart, MovesWithTheFirstVertex) {
  const GeoReference place{.west = 100.0,
                           .north = 900.0,
                           .column_step = 3.0,
                           .row_step = -4.0,
                           .projection = "somewhere"};
  const GeoReference part = place_of_part(place, {.first_column = 2, .first_row = 5});
  EXPECT_EQ(part.west, 106.0);
  EXPECT_EQ(part.north, 880.0);
  EXPECT_EQ(part.column_step, 3.0);
  EXPECT_EQ(part.projection, "somewhere");
}

TEST(PlaceOnCells, KeepsTheMiddleOfTheFirstCell) {
  const GeoReference place{.west = 10.0, .north = 50.0, .column_step = 0.5, .row_step = -0.25};
  const HeightField field = numbered(11, 11, 40.0, 30.0), result = on_square_cells(field, 10.0);
  const GeoReference moved = place_on_cells(place, field, result);
  EXPECT_NEAR(moved.column_step, 0.125, 1e-15);
  EXPECT_NEAR(moved.row_step, -0.25 / 3.0, 1e-15);
  EXPECT_NEAR(moved.west + moved.column_step / 2.0, 10.25, 1e-14);
  EXPECT_NEAR(moved.north + moved.row_step / 2.0, 49.875, 1e-14);
}

}  // namespace
}  // namespace phytobench
