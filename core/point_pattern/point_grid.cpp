// SPDX-License-Identifier: MIT
#include "core/point_pattern/point_grid.hpp"

#include <cmath>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

GridAxis make_axis(double low, double high, double least_edge, bool joined) {
  const double extent = high - low;
  GridAxis axis{low, extent, 0.0, 1, joined};
  const double cells = std::max(1.0, std::floor(extent / least_edge));
  // Points without extent, or with one too small to divide by, share a cell.
  if (!std::isfinite(cells / extent)) return axis;
  axis.cells = static_cast<std::int64_t>(cells);
  axis.edge = extent / cells;
  axis.inverse_edge = cells / extent;
  return axis;
}

Rectangle box_of(std::span<const Point2> points, const Window& window) {
  const Rectangle& whole = window.bounding_box();
  for (const Point2& p : points) PHYTOBENCH_EXPECT(whole.contains(p));
  if (window.kind() == WindowKind::torus || points.empty()) return whole;
  Rectangle box{points[0], points[0]};
  for (const Point2& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

}  // namespace

PointGrid::PointGrid(std::span<const Point2> points, const Window& window, double points_per_cell,
                     double least_edge) {
  PHYTOBENCH_EXPECT(points.size() < std::numeric_limits<std::uint32_t>::max());
  PHYTOBENCH_EXPECT(points_per_cell > 0.0 && least_edge >= 0.0);
  const Rectangle box = box_of(points, window);
  const double share =
      std::min(1.0, points_per_cell / std::max(1.0, static_cast<double>(points.size())));
  // The second bound keeps points in a line from getting a cell row each: side * side cells.
  const double edge = std::max({least_edge, std::sqrt(share * box.width() * box.height()),
                                share * std::max(box.width(), box.height())});
  const bool joined = window.kind() == WindowKind::torus;
  columns_ = make_axis(box.low.x, box.high.x, edge, joined);
  rows_ = make_axis(box.low.y, box.high.y, edge, joined);
  sort_in(points);
}

double PointGrid::mean_company() const {
  if (points_.empty()) return 0.0;
  double pairs = 0.0;
  for (std::size_t c = 0; c + 1 < begins_.size(); ++c) {
    const double count = begins_[c + 1] - begins_[c];
    pairs += count * count;
  }
  return pairs / static_cast<double>(points_.size());
}

void PointGrid::sort_in(std::span<const Point2> points) {
  std::vector<std::uint32_t> cells(points.size());
  begins_.assign(static_cast<std::size_t>(columns_.cells * rows_.cells) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cells[i] = static_cast<std::uint32_t>(rows_.cell_of(points[i].y) * columns_.cells +
                                          columns_.cell_of(points[i].x));
    ++begins_[cells[i]];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begins_) begin = end += begin;

  // Filling each cell from its end, last point first, leaves the begins where they belong and the
  // points of a cell in their original order.
  points_.resize(points.size());
  indices_.resize(points.size());
  for (std::size_t i = points.size(); i-- > 0;) {
    const std::uint32_t place = --begins_[cells[i]];
    points_[place] = points[i];
    indices_[place] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace phytobench
