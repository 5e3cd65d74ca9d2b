// SPDX-License-Identifier: MIT
#include "core/terrain/height_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;

TEST(HeightField, CountsRowByRow) {
  HeightField field(3, 2, 10.0, 20.0, 5.0);
  EXPECT_EQ(field.size(), 6u);
  EXPECT_THAT(field.heights(), testing::Each(5.0));
  field.at(2, 0) = 7.0;
  field.at(1, 1) = 8.0;
  EXPECT_EQ(field.index(1, 1), 4u);
  EXPECT_EQ(field.heights()[2], 7.0);
  EXPECT_EQ(field.row(1)[1], 8.0);
  EXPECT_EQ(field.cell_width(), 10.0);
  EXPECT_EQ(field.cell_depth(), 20.0);
}

TEST(HeightField, TakesHeightsRowByRow) {
  const HeightField field(2, 2, 10.0, 20.0, {1.0, 2.0, 3.0, 4.0});
  EXPECT_EQ(field.at(1, 0), 2.0);
  EXPECT_EQ(field.at(0, 1), 3.0);
}

TEST(HeightField, RefusesWhatIsNoMap) {
  EXPECT_THROW(HeightField(2, 2, 1.0, 1.0, {1.0, 2.0, 3.0}), ContractViolation);
  EXPECT_THROW(HeightField(0, 1, 1.0, 1.0), ContractViolation);
  EXPECT_THROW(HeightField(1, -1, 1.0, 1.0), ContractViolation);
  EXPECT_THROW(HeightField(1, 1, 0.0, 1.0), ContractViolation);
  EXPECT_THROW(HeightField(1, 1, 1.0, HeightField::no_data), ContractViolation);
}

TEST(HeightField, RangeLeavesOutWhatHasNoData) {
  HeightField field(3, 1, 1.0, 1.0, HeightField::no_data);
  EXPECT_TRUE(height_range(field).empty());
  EXPECT_GT(height_range(field).lowest, height_range(field).highest);
  field.at(0, 0) = -3.0;
  field.at(2, 0) = 4.0;
  EXPECT_FALSE(field.has_data(1, 0));
  const HeightRange range = height_range(field);
  EXPECT_EQ(range.lowest, -3.0);
  EXPECT_EQ(range.highest, 4.0);
  EXPECT_EQ(range.vertices, 2u);
}

TEST(HeightField, TransposesRowsIntoColumns) {
  HeightField field(70, 41, 2.0, 3.0);
  for (std::size_t i = 0; i < field.size(); ++i) field.heights()[i] = static_cast<double>(i);
  const HeightField other = transposed(field);
  EXPECT_EQ(other.columns(), 41);
  EXPECT_EQ(other.rows(), 70);
  EXPECT_EQ(other.cell_width(), 3.0);
  EXPECT_EQ(other.cell_depth(), 2.0);
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 70; ++column)
      ASSERT_EQ(other.at(row, column), field.at(column, row));
  EXPECT_THAT(transposed(HeightField(1, 3, 1.0, 1.0, 2.0)).heights(), ElementsAre(2, 2, 2));
}

}  // namespace
}  // namespace phytobench
