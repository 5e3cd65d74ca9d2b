// SPDX-License-Identifier: MIT
#include "core/point_pattern/lattices.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/point_pattern/point_limit.hpp"

namespace phytobench {

namespace {

/// One point per cell; `place(row)` says where in its cell, as shares of the cell's sides in
/// [0, 1].
template <typename Place>
std::vector<Point2> point_per_cell(const Rectangle& rectangle, std::size_t columns,
                                   std::size_t rows, const Place& place) {
  PHYTOBENCH_EXPECT(columns > 0 && rows > 0);
  PHYTOBENCH_EXPECT(rectangle.width() > 0.0 && rectangle.height() > 0.0 &&
                    std::isfinite(rectangle.area()));
  const auto across = static_cast<double>(columns), up = static_cast<double>(rows);
  refuse_too_many_points(across * up, "lower the number of columns or rows");
  std::vector<Point2> points;
  points.reserve(columns * rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const Point2 share = place(row);
      const double x = rectangle.width() * ((static_cast<double>(column) + share.x) / across);
      const double y = rectangle.height() * ((static_cast<double>(row) + share.y) / up);
      // Rounding must not carry a point out of the rectangle.
      points.push_back({std::min(rectangle.low.x + x, rectangle.high.x),
                        std::min(rectangle.low.y + y, rectangle.high.y)});
    }
  return points;
}

}  // namespace

std::vector<Point2> square_lattice(const Rectangle& rectangle, std::size_t columns,
                                   std::size_t rows) {
  return point_per_cell(rectangle, columns, rows, [](std::size_t) { return Point2{0.5, 0.5}; });
}

std::vector<Point2> triangular_lattice(const Rectangle& rectangle, std::size_t columns,
                                       std::size_t rows) {
  PHYTOBENCH_EXPECT(rows % 2 == 0);
  // A quarter and three quarters: the shift is half a step and no point leaves its cell.
  return point_per_cell(rectangle, columns, rows, [](std::size_t row) {
    return Point2{row % 2 == 0 ? 0.25 : 0.75, 0.5};
  });
}

std::vector<Point2> jittered_lattice(const Rectangle& rectangle, std::size_t columns,
                                     std::size_t rows, UnitStream& stream) {
  return point_per_cell(rectangle, columns, rows, [&stream](std::size_t) {
    const double x = stream.next_unit();
    return Point2{x, stream.next_unit()};
  });
}

}  // namespace phytobench
