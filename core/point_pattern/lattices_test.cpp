// SPDX-License-Identifier: MIT
#include "core/point_pattern/lattices.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/window.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

constexpr double coordinate_rounding = 1e-12;  // coordinates below 10

/// Distances from each point to all others on the torus, ascending; one row per point.
std::vector<std::vector<double>> sorted_distances(const std::vector<Point2>& points,
                                                  const Rectangle& box) {
  const Window periodic_box = Window::torus(box);
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double>& row = rows.emplace_back();
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i) row.push_back(norm(periodic_box.difference(points[i], points[j])));
    std::sort(row.begin(), row.end());
  }
  return rows;
}

TEST(SquareLattice, IsTheCellsCentresRowByRow) {
  const std::vector<Point2> expected{{1.5, 3.25}, {2.5, 3.25}, {3.5, 3.25},
                                     {1.5, 3.75}, {2.5, 3.75}, {3.5, 3.75}};
  EXPECT_EQ(square_lattice({{1, 3}, {4, 4}}, 3, 2), expected);
}

TEST(SquareLatticeLaw, EachPointHasFourNearestNeighboursOnTheTorus) {
  const Rectangle box{{-2, 1}, {3, 5}};
  const auto points = square_lattice(box, 10, 8);
  ASSERT_EQ(points.size(), 80u);
  for (const auto& distances : sorted_distances(points, box)) {
    EXPECT_NEAR(distances[0], 0.5, coordinate_rounding);
    EXPECT_NEAR(distances[3], 0.5, coordinate_rounding);
    EXPECT_NEAR(distances[4], 0.5 * std::sqrt(2.0), coordinate_rounding);
  }
}

TEST(TriangularLatticeLaw, EachPointHasSixNearestNeighboursOnTheTorus) {
  const Rectangle box{{-2, 1}, {4, 1 + 8 * 0.5 * std::sqrt(3.0)}};
  const auto points = triangular_lattice(box, 6, 8);
  ASSERT_EQ(points.size(), 48u);
  for (const auto& distances : sorted_distances(points, box)) {
    EXPECT_NEAR(distances[0], 1.0, coordinate_rounding);
    EXPECT_NEAR(distances[5], 1.0, coordinate_rounding);
    EXPECT_NEAR(distances[6], std::sqrt(3.0), coordinate_rounding);
  }
}

TEST(TriangularLattice, ShiftsEveryOtherRowByHalfAStep) {
  const std::vector<Point2> expected{{0.25, 0.5}, {1.25, 0.5}, {0.75, 1.5}, {1.75, 1.5}};
  EXPECT_EQ(triangular_lattice({{0, 0}, {2, 2}}, 2, 2), expected);
}

TEST(TriangularLattice, ExpectsAnEvenNumberOfRows) {
  EXPECT_THROW(triangular_lattice({{0, 0}, {1, 1}}, 4, 3), ContractViolation);
}

TEST(JitteredLatticeLaw, HasOneUniformPointPerCell) {
  constexpr std::size_t columns = 70, rows = 50;
  const Rectangle box{{10, -3}, {17, 7}};
  CounterStream stream(3, 0);
  const auto points = jittered_lattice(box, columns, rows, stream);
  ASSERT_EQ(points.size(), columns * rows);
  std::vector<std::int64_t> places(16, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = (points[i].x - 10.0) / 0.1 - static_cast<double>(i % columns);
    const double y = (points[i].y + 3.0) / 0.2 - static_cast<double>(i / columns);
    ASSERT_TRUE(x > -coordinate_rounding && x < 1.0 + coordinate_rounding &&
                y > -coordinate_rounding && y < 1.0 + coordinate_rounding)
        << i;
    const auto quarter = [](double share) {
      return static_cast<std::size_t>(std::clamp(4.0 * share, 0.0, 3.0));
    };
    ++places[quarter(y) * 4 + quarter(x)];
  }
  EXPECT_GT(uniformity_p_value(places), 1e-4);  // about four standard errors
}

TEST(JitteredLattice, IsAFunctionOfTheStream) {
  CounterStream one(1, 0), same(1, 0), other(2, 0);
  const Rectangle box{{0, 0}, {1, 1}};
  const auto points = jittered_lattice(box, 5, 5, one);
  EXPECT_EQ(points, jittered_lattice(box, 5, 5, same));
  EXPECT_NE(points, jittered_lattice(box, 5, 5, other));
}

/// The highest number below 1 for ever.
class HighestStream final : public UnitStream {
 public:
  double next_unit() override { return 1.0 - 0x1p-53; }
};

TEST(JitteredLattice, StaysInsideAtTheHighestNumbers) {
  HighestStream stream;
  const Rectangle box{{0.1, 0.1}, {0.7, 0.4}};
  for (const Point2& p : jittered_lattice(box, 7, 3, stream)) EXPECT_TRUE(box.contains(p));
}

TEST(Lattices, RefuseNoCellsNoAreaAndTooManyPoints) {
  CounterStream stream(1, 0);
  const Rectangle unit{{0, 0}, {1, 1}};
  EXPECT_THROW(square_lattice(unit, 0, 3), ContractViolation);
  EXPECT_THROW(triangular_lattice(unit, 3, 0), ContractViolation);
  EXPECT_THROW(jittered_lattice(unit, 0, 0, stream), ContractViolation);
  EXPECT_THROW(square_lattice({{0, 0}, {0, 1}}, 2, 2), ContractViolation);
  EXPECT_THROW(square_lattice({{0, 0}, {1, std::nan("")}}, 2, 2), ContractViolation);
  EXPECT_THROW(square_lattice(unit, 100'000, 100'000), InputError);
}

}  // namespace
}  // namespace phytobench
