// SPDX-License-Identifier: MIT
#include "core/terrain/files/number_rows.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Raster rows_of(std::string_view text) {
  return parse_number_rows(text, "hill.csv");
}

std::string rows_error(const std::string& text) {
  return input_error_of([&] { rows_of(text); });
}

TEST(NumberRows, GivesRowsFromTheNorth) {
  const Raster raster = rows_of("\xef\xbb\xbf# heights\n1, 2.5 ,3\r\n\n-4e1,+5,6\n");
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 2);
  EXPECT_THAT(raster.values, ElementsAre(1.0, 2.5, 3.0, -40.0, 5.0, 6.0));
  EXPECT_FALSE(raster.place);
  EXPECT_EQ(raster.format, "CSV");
}

TEST(NumberRows, AreWithoutDataWhereNothingOrNanStands) {
  const Raster raster = rows_of("1,,nan\nNaN,5,\n");
  EXPECT_EQ(raster.columns, 3);
  const bool no_data[] = {false, true, true, true, false, true};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(std::isnan(raster.values[i]), no_data[i]) << i;
}

TEST(NumberRows, ASingleColumnRowOrNumberIsAMap) {
  EXPECT_EQ(rows_of("1\n2\n3").rows, 3);
  EXPECT_EQ(rows_of("1,2,3").columns, 3);
  EXPECT_THAT(rows_of("7").values, ElementsAre(7.0));
}

TEST(NumberRows, RefusesRowsOfOtherLengths) {
  EXPECT_EQ(rows_error("1,2\n\n3,4,5\n"),
            "hill.csv:3: 3 numbers where the first row has 2; complete or remove the line");
  EXPECT_THAT(rows_error("1,2\n3\n"), StartsWith("hill.csv:2: 1 numbers"));
}

TEST(NumberRows, RefusesWhatIsNoNumber) {
  EXPECT_THAT(rows_error("x,y,z\n1,2,3\n"), StartsWith("hill.csv:1: 'x' is no finite number"));
  EXPECT_THAT(rows_error("1,inf\n"), HasSubstr("'inf'"));
  EXPECT_THAT(rows_error("1,1e400\n"), HasSubstr("'1e400'"));
  EXPECT_THAT(rows_error("1;2;3\n"), StartsWith("hill.csv:1: '1;2;3' has semicolons between"));
  EXPECT_THAT(rows_error("1,2\n1,5;2,5\n"), StartsWith("hill.csv:2: '5;2' has semicolons"));
  EXPECT_THAT(rows_error("1 2,3\n"), HasSubstr("'1 2'"));
  EXPECT_THAT(rows_error("nan 2,3\n"), HasSubstr("'nan 2'"));
  EXPECT_THAT(rows_error(std::string(100, 'a')), HasSubstr(std::string(40, 'a') + "...'"));
}

TEST(NumberRows, RefusesFilesWithoutNumbers) {
  for (const char* text : {"", "\n\n", "# nothing\n"})
    EXPECT_EQ(rows_error(text), "hill.csv: holds no row of numbers; give at least one");
}

}  // namespace
}  // namespace phytobench
