// SPDX-License-Identifier: MIT
#include "core/point_pattern/nearest_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract/check.hpp"
#include "core/geometry/point_tree.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/point_pattern/point_grid.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

constexpr double points_per_cell = 2.0;
constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// Where a query stands along one axis, and which cells there are on either side of its own.
struct Place {
  std::int64_t cell, lowest, highest;  // offsets of the last cells to either side
  bool joined;
  double to_low, to_high;  // from the query to its cell's ends, in cells
  double edge;

  Place(const GridAxis& axis, double value)
      : cell(axis.cell_of(value)), joined(axis.joined), edge(axis.edge) {
    // Around a torus every cell is reached the shorter way, and once.
    lowest = axis.joined ? -((axis.cells - 1) / 2) : -cell;
    highest = axis.joined ? axis.cells / 2 : axis.cells - 1 - cell;
    to_low = axis.position(value) - static_cast<double>(cell);
    to_high = 1.0 - to_low;
  }

  /// A lower bound on the distance to all cells more than `ring` off along this axis.
  double gap_beyond(std::int64_t ring) const {
    double cells = infinite_distance;
    // On a torus the last cell to be seen may be nearer by the other way round.
    if (joined ? ring < highest : -ring > lowest) cells = to_low;
    if (ring < highest) cells = std::min(cells, to_high);
    return cells == infinite_distance
               ? infinite_distance
               : edge * std::max(0.0, static_cast<double>(ring) + cells - grid_slack);
  }
};

/// Looks through squares of cells around a query until no unseen cell can hold a nearer point.
class Search {
 public:
  Search(const PointGrid& grid, const Window& window, const Point2& query, std::size_t self)
      : grid_(grid),
        window_(window),
        query_(query),
        self_(self),
        column_(grid.columns(), query.x),
        row_(grid.rows(), query.y) {}

  double nearest() {
    std::int64_t ring = 1;
    for (std::int64_t up = -1; up <= 1; ++up) see_row(up, -1, 1);
    while (!is_settled(ring)) {
      ++ring;
      see_row(-ring, -ring, ring);
      see_row(ring, -ring, ring);
      for (std::int64_t up = 1 - ring; up < ring; ++up) {
        see_row(up, -ring, -ring);
        see_row(up, ring, ring);
      }
    }
    return std::sqrt(least_);
  }

 private:
  bool is_settled(std::int64_t ring) const {
    const double gap = std::min(column_.gap_beyond(ring), row_.gap_beyond(ring));
    return gap == infinite_distance || least_ <= gap * gap;
  }

  /// The cells at offsets [first, last] of the row `up` rows above.
  void see_row(std::int64_t up, std::int64_t first, std::int64_t last) {
    if (up < row_.lowest || up > row_.highest) return;
    first = column_.cell + std::max(first, column_.lowest);
    last = column_.cell + std::min(last, column_.highest);
    if (first > last) return;
    const std::int64_t rows = grid_.rows().cells, columns = grid_.columns().cells;
    const std::int64_t row = (row_.cell + up + rows) % rows;
    if (first < 0) see(row, first + columns, std::min(last, std::int64_t{-1}) + columns);
    see(row, std::max(first, std::int64_t{0}), std::min(last, columns - 1));
    if (last >= columns) see(row, std::max(first, columns) - columns, last - columns);
  }

  void see(std::int64_t row, std::int64_t first, std::int64_t last) {
    if (first > last) return;
    const std::size_t begin = grid_.begin_of(row, first), end = grid_.end_of(row, last);
    if (self_ < begin || self_ >= end) return see_points(begin, end);
    see_points(begin, self_);
    see_points(self_ + 1, end);
  }

  void see_points(std::size_t begin, std::size_t end) {
    constexpr std::size_t batch = 64;
    const Point2* const points = grid_.points();
    const bool wraps = window_.kind() == WindowKind::torus;
    // Heaps of twins end at once: nothing is nearer than 0.
    while (begin < end && least_ > 0.0) {
      const std::size_t stop = std::min(end, begin + batch);
      for (; begin < stop; ++begin) {
        const Point2 d = wraps ? window_.difference(query_, points[begin]) : points[begin] - query_;
        least_ = std::min(least_, d.x * d.x + d.y * d.y);
      }
    }
  }

  const PointGrid& grid_;
  const Window& window_;
  Point2 query_;
  std::size_t self_;  // the query's own position in the grid
  Place column_, row_;
  double least_ = infinite_distance;
};

/// The same through a balanced tree, for patterns whose points crowd into few cells.
class TreeSearch {
 public:
  TreeSearch(std::span<const Point2> points, const Window& window)
      : tree_(points), window_(window) {
    const bool goes_round = window.kind() == WindowKind::torus;
    const int reach = goes_round ? 1 : 0;
    for (int ky = -reach; ky <= reach; ++ky)
      for (int kx = -reach; kx <= reach; ++kx)
        images_.push_back(
            {kx * window.bounding_box().width(), ky * window.bounding_box().height()});
  }

  /// To the nearest point but the one with index `self`.
  double nearest(const Point2& query, std::size_t self) const {
    double least = infinite_distance;
    // Boxes of images are where rounding puts them: a little more is looked at.
    const auto reach = [&least] { return least * (1.0 + 1e-12); };
    for (const Point2& image : images_)
      tree_.visit_all(query - image, reach, [&](std::size_t place) {
        if (tree_.index(place) == self) return;
        const Point2 d = window_.difference(query, tree_.point(place));
        least = std::min(least, d.x * d.x + d.y * d.y);
      });
    return std::sqrt(least);
  }

 private:
  PointTree tree_;
  const Window& window_;
  std::vector<Point2> images_;
};

/// Points that share a cell with a point on average, beyond which the tree is faster.
constexpr double crowded = 60.0;

}  // namespace

std::vector<double> nearest_distances(std::span<const Point2> points, const Window& window,
                                      int threads) {
  const PointGrid grid(points, window, points_per_cell);
  std::vector<double> distances(points.size());
  if (grid.mean_company() > crowded) {
    const TreeSearch search(points, window);
    for_blocks(points.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) distances[i] = search.nearest(points[i], i);
    });
    return distances;
  }
  for_blocks(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      distances[grid.indices()[i]] = Search(grid, window, grid.points()[i], i).nearest();
  });
  return distances;
}

std::vector<double> nearest_distances_from(std::span<const Point2> queries,
                                           std::span<const Point2> points, const Window& window,
                                           int threads) {
  for (const Point2& query : queries) PHYTOBENCH_EXPECT(window.bounding_box().contains(query));
  const PointGrid grid(points, window, points_per_cell);
  std::vector<double> distances(queries.size());
  if (grid.mean_company() > crowded) {
    const TreeSearch search(points, window);
    for_blocks(queries.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) distances[i] = search.nearest(queries[i], nobody);
    });
    return distances;
  }
  for_blocks(queries.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      distances[i] = Search(grid, window, queries[i], nobody).nearest();
  });
  return distances;
}

}  // namespace phytobench
