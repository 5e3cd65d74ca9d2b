// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Equal cells along one direction.
struct GridAxis {
  double low = 0.0;
  double edge = 0.0;          ///< of a cell
  double inverse_edge = 0.0;  ///< 0 if all points share this coordinate: one cell then
  std::int64_t cells = 1;
  bool joined = false;  ///< the last cell is a neighbour of the first

  /// In cells from the low end. Its rounding error stays below grid_slack.
  double position(double value) const { return (value - low) * inverse_edge; }
  /// Values beyond either end fall into the last cell there.
  std::int64_t cell_of(double value) const {
    return static_cast<std::int64_t>(
        std::clamp(position(value), 0.0, static_cast<double>(cells - 1)));
  }
};

/// In cells; what bounds on cell distances must leave for the rounding of positions. A position is
/// at most 2^32 and carries three roundings.
inline constexpr double grid_slack = 1e-5;

/// Points sorted into the cells of a grid, row by row, so that neighbouring cells of a row lie side
/// by side in memory. On a torus the cells divide the window, elsewhere the points' bounding box.
class PointGrid {
 public:
  /// Cells are no narrower than `least_edge` and hold at least `points_per_cell` points on average,
  /// whatever the shape of the pattern. Expects all points inside the window's bounding box and
  /// fewer than 2^32 of them.
  PointGrid(std::span<const Point2> points, const Window& window, double points_per_cell,
            double least_edge = 0.0);

  const GridAxis& columns() const { return columns_; }
  const GridAxis& rows() const { return rows_; }
  std::size_t size() const { return points_.size(); }

  /// Where the points of the cells [first, last] of a row begin and end.
  std::size_t begin_of(std::int64_t row, std::int64_t first) const {
    return begins_[static_cast<std::size_t>(row * columns_.cells + first)];
  }
  std::size_t end_of(std::int64_t row, std::int64_t last) const {
    return begins_[static_cast<std::size_t>(row * columns_.cells + last + 1)];
  }

  /// How many points, itself among them, a point shares its cell with on average; 0 without points.
  double mean_company() const;

  const Point2* points() const { return points_.data(); }           ///< by cell
  const std::uint32_t* indices() const { return indices_.data(); }  ///< in the original order

 private:
  void sort_in(std::span<const Point2> points);

  GridAxis columns_, rows_;
  std::vector<std::uint32_t> begins_;  // per cell, and the end
  std::vector<Point2> points_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace phytobench
