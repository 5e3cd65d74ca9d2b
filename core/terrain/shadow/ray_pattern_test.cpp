// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/ray_pattern.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {

/// Found by the matchers below.
std::ostream& operator<<(std::ostream& out, const RayCrossing& c) {
  return out << c.near << " to " << c.far << ", " << c.fraction << ", rise " << c.rise << ", "
             << c.columns << " columns, " << c.rows << " rows";
}

namespace {

void expect_crossings(const RayPattern& pattern, const std::vector<RayCrossing>& expected) {
  ASSERT_EQ(pattern.crossings().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const RayCrossing& found = pattern.crossings()[i];
    EXPECT_EQ(found.near, expected[i].near) << found;
    EXPECT_EQ(found.far, expected[i].far) << found;
    EXPECT_NEAR(found.fraction, expected[i].fraction, 1e-14) << found;
    EXPECT_NEAR(found.rise, expected[i].rise, 1e-12) << found;
    EXPECT_EQ(found.columns, expected[i].columns) << found;
    EXPECT_EQ(found.rows, expected[i].rows) << found;
  }
}

TEST(RayPattern, MeetsVerticesAlongTheAxes) {
  const HeightField field(4, 3, 10.0, 20.0);
  expect_crossings({field, {1.0, 0.0, 0.5}},
                   {{1, 1, 0, 5, 1, 0}, {2, 2, 0, 10, 2, 0}, {3, 3, 0, 15, 3, 0}});
  expect_crossings({field, {-2.0, 0.0, 1.0}},
                   {{-1, -1, 0, 5, 1, 0}, {-2, -2, 0, 10, 2, 0}, {-3, -3, 0, 15, 3, 0}});
  expect_crossings({field, {0.0, 1.0, 0.5}}, {{4, 4, 0, 10, 0, 1}, {8, 8, 0, 20, 0, 2}});
  expect_crossings({field, {0.0, -1.0, 0.0}}, {{-4, -4, 0, 0, 0, 1}, {-8, -8, 0, 0, 0, 2}});
}

TEST(RayPattern, MeetsVerticesAlongDiagonals) {
  const double length = std::sqrt(2.0);
  expect_crossings(
      {HeightField(4, 4, 1.0, 1.0), {1.0, -1.0, length}},
      {{-3, -3, 0, length, 1, 1}, {-6, -6, 0, 2 * length, 2, 2}, {-9, -9, 0, 3 * length, 3, 3}});
  // Cells of 3 x 4: the diagonal has 5.
  expect_crossings({HeightField(3, 3, 3.0, 4.0), {-3.0, 4.0, 5.0}},
                   {{2, 2, 0, 5, 1, 1}, {4, 4, 0, 10, 2, 2}});
}

TEST(RayPattern, MeetsLinesBetweenVertices) {
  const double step = std::sqrt(1.25);  // m between columns
  expect_crossings({HeightField(5, 3, 1.0, 1.0), {2.0, 1.0, std::sqrt(5.0)}},
                   {{1, 6, 0.5, step, 1, 1},
                    {7, 7, 0, 2 * step, 2, 1},
                    {8, 13, 0.5, 3 * step, 3, 2},
                    {14, 14, 0, 4 * step, 4, 2}});
  expect_crossings(
      {HeightField(3, 4, 1.0, 1.0), {-1.0, -3.0, 0.0}},
      {{-3, -4, 1.0 / 3, 0, 1, 1}, {-6, -7, 2.0 / 3, 0, 1, 2}, {-10, -10, 0, 0, 1, 3}});
}

/// Rounding puts a third of a tenth beside the vertex along rows, but not along columns.
TEST(RayPattern, MeetsAVertexThatRoundingHasMoved) {
  for (const double cell : {0.1, 0.7, 1.0, 16.0})
    for (const double long_way : {3.0, 7.0, 49.0})
      for (const bool by_rows : {false, true}) {
        const HeightField field(60, 60, cell, cell);
        const RayPattern pattern(
            field, by_rows ? SunDirection{-1.0, long_way, 1.0} : SunDirection{-long_way, 1.0, 1.0});
        const int n = static_cast<int>(long_way);
        const std::ptrdiff_t vertex = by_rows ? -1 + 60 * n : -n + 60;
        const auto met = std::ranges::find(pattern.crossings(), vertex, &RayCrossing::near);
        ASSERT_NE(met, pattern.crossings().end()) << cell << ", " << long_way;
        EXPECT_EQ(met->far, vertex);
        EXPECT_EQ(met->fraction, 0.0);
        EXPECT_EQ(std::ranges::count(pattern.crossings(), vertex, &RayCrossing::near), 1);
      }
}

TEST(RayPattern, KnowsHowManyCrossingsAreOnTheMap) {
  const HeightField field(5, 3, 1.0, 1.0);
  const RayPattern pattern(field, {2.0, 1.0, 1.0});
  EXPECT_EQ(pattern.on_map(0, 0), 4u);
  EXPECT_EQ(pattern.on_map(1, 0), 3u);
  EXPECT_EQ(pattern.on_map(3, 0), 1u);
  EXPECT_EQ(pattern.on_map(4, 0), 0u);
  EXPECT_EQ(pattern.on_map(0, 1), 2u) << "the third lies between rows 2 and 3";
  EXPECT_EQ(pattern.on_map(0, 2), 0u);
  EXPECT_EQ(pattern.within(4, 1), 2u);
  const RayPattern back(field, {-2.0, -1.0, 1.0});
  EXPECT_EQ(back.on_map(4, 2), 4u);
  EXPECT_EQ(back.on_map(0, 2), 0u);
  EXPECT_FALSE(back.goes_east());
  EXPECT_FALSE(back.goes_south());
}

TEST(RayPattern, LeavesMapsOfOneRowOrColumnAtOnceUnlessAlongThem) {
  const HeightField row(7, 1, 1.0, 1.0), column(1, 7, 1.0, 1.0), vertex(1, 1, 1.0, 1.0);
  EXPECT_EQ(RayPattern(row, {1.0, 0.0, 1.0}).crossings().size(), 6u);
  EXPECT_TRUE(RayPattern(row, {1.0, 0.1, 1.0}).crossings().empty());
  EXPECT_TRUE(RayPattern(row, {0.0, 1.0, 1.0}).crossings().empty());
  EXPECT_EQ(RayPattern(column, {0.0, -1.0, 1.0}).on_map(0, 6), 6u);
  EXPECT_TRUE(RayPattern(column, {1.0, -1.0, 1.0}).crossings().empty());
  EXPECT_EQ(RayPattern(vertex, {1.0, 1.0, 1.0}).on_map(0, 0), 0u);
}

TEST(RayPattern, CrossingsComeInOrderAndStayOnTheMap) {
  const HeightField field(40, 30, 7.3, 9.1);
  for (const double east : {-3.0, -0.01, 0.0, 0.4, 2.0})
    for (const double south : {-2.0, -0.3, 0.02, 1.7}) {
      const RayPattern pattern(field, {east, south, 0.6});
      double rise = 0.0;
      int columns = 0, rows = 0;
      for (const RayCrossing& crossing : pattern.crossings()) {
        EXPECT_GE(crossing.rise, rise);
        EXPECT_GE(crossing.columns, columns);
        EXPECT_GE(crossing.rows, rows);
        EXPECT_LT(crossing.columns, 40);
        EXPECT_LT(crossing.rows, 30);
        EXPECT_GE(crossing.fraction, 0.0);
        EXPECT_LT(crossing.fraction, 1.0);
        rise = crossing.rise;
        columns = crossing.columns;
        rows = crossing.rows;
      }
      EXPECT_GE(pattern.crossings().size(), 28u);
    }
}

TEST(RayPattern, RefusesSunsWithoutARay) {
  const HeightField field(3, 3, 1.0, 1.0);
  EXPECT_THROW(RayPattern(field, {0.0, 0.0, 1.0}), ContractViolation);
  EXPECT_THROW(RayPattern(field, {1.0, 0.0, -0.1}), ContractViolation);
}

TEST(HeightAtCrossing, LiesBetweenBothVerticesWhateverIsRounded) {
  const auto between = [](double a, double b, double fraction) {
    const double heights[] = {a, b};
    return height_at({.near = 0, .far = 1, .fraction = fraction}, heights);
  };
  EXPECT_EQ(between(2.0, 4.0, 0.5), 3.0);
  EXPECT_EQ(between(4.0, 2.0, 0.25), 3.5);
  EXPECT_EQ(between(5.0, 5.0, 0.3), 5.0);
  EXPECT_TRUE(std::isnan(between(HeightField::no_data, 1.0, 0.5)));
  EXPECT_TRUE(std::isnan(between(1.0, HeightField::no_data, 0.5)));
  const double almost = std::nextafter(1.0, 0.0);
  for (const double a : {0.1, -7.3, 1e9, 1e-9})
    for (const double b : {0.3, 2.7, -1e9, 1e-10})
      EXPECT_LE(between(a, b, almost), std::max(a, b)) << a << ", " << b;
}

}  // namespace
}  // namespace phytobench
