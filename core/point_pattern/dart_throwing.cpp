// SPDX-License-Identifier: MIT
#include "core/point_pattern/dart_throwing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/point_pattern/bucket_grid.hpp"
#include "core/point_pattern/point_limit.hpp"

namespace phytobench {

namespace {

/// Part of a bucket that may hold free ground: its place within the bucket, in its own sizes.
struct Cell {
  std::uint32_t bucket;
  std::uint32_t column;
  std::uint32_t row;
};

constexpr int most_halvings = 30;  // 32 bits hold a cell's place in its bucket

/// Whether the segment from a to b comes as near to p as `distance`.
bool is_segment_near(const Point2& a, const Point2& b, const Point2& p, double distance) {
  const Point2 along = b - a;
  const double share = std::clamp(dot(p - a, along) / squared_norm(along), 0.0, 1.0);
  return squared_norm(a + share * along - p) <= distance * distance;
}

class DartBoard {
 public:
  DartBoard(const Window& window, double side, double distance, UnitStream& stream)
      : window_(window),
        grid_(window, side, distance),
        squared_distance_(distance * distance),
        stream_(stream) {
    set_cell_size();
    const std::uint32_t buckets = grid_.columns() * grid_.rows();
    for (std::uint32_t bucket = 0; bucket < buckets; ++bucket)
      if (touches_window(centre({bucket, 0, 0}))) cells_.push_back({bucket, 0, 0});
  }

  std::vector<Point2> throw_until(std::size_t most) {
    // Split the cells as soon as most darts miss: earlier costs memory, later time.
    constexpr double worth_going_on = 0.25;
    while (!cells_.empty() && grid_.points().size() < most) {
      const auto darts = static_cast<double>(cells_.size());
      const std::size_t hits = throw_round(most);
      if (static_cast<double>(hits) >= worth_going_on * darts) continue;
      if (std::max(halvings_across_, halvings_up_) == most_halvings) break;
      split_cells();
    }
    return grid_.take_points();
  }

 private:
  void set_cell_size() {
    cell_size_ = {std::ldexp(grid_.bucket_size().x, -halvings_across_),
                  std::ldexp(grid_.bucket_size().y, -halvings_up_)};
    half_diagonal_ = 0.5 * norm(cell_size_);
  }

  /// The place in a cell at these shares of its sides.
  Point2 place_in(const Cell& cell, double x_share, double y_share) const {
    const Rectangle& box = window_.bounding_box();
    const Point2& size = grid_.bucket_size();
    const double x = (cell.column + x_share) * cell_size_.x;
    const double y = (cell.row + y_share) * cell_size_.y;
    // Rounding must not carry a point out of the box.
    return {std::min(box.low.x + ((cell.bucket % grid_.columns()) * size.x + x), box.high.x),
            std::min(box.low.y + ((cell.bucket / grid_.columns()) * size.y + y), box.high.y)};
  }

  Point2 centre(const Cell& cell) const { return place_in(cell, 0.5, 0.5); }

  /// Whether all of the cell around this centre is nearer to the point than the distance.
  bool covers(const Point2& point, const Point2& cell_centre) const {
    const Point2 d = window_.difference(point, cell_centre);
    const Point2 farthest{std::abs(d.x) + 0.5 * cell_size_.x, std::abs(d.y) + 0.5 * cell_size_.y};
    return squared_norm(farthest) < squared_distance_;
  }

  /// False only if the cell around this centre lies outside of the window.
  bool touches_window(const Point2& cell_centre) const {
    if (window_.kind() != WindowKind::polygon || window_.contains(cell_centre)) return true;
    const std::vector<Point2>& corners = window_.corners();
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
      if (is_segment_near(corners[j], corners[i], cell_centre, half_diagonal_)) return true;
    return false;
  }

  void drop(std::size_t i) {
    cells_[i] = cells_.back();
    cells_.pop_back();
  }

  /// One dart for each cell there is; returns how many found a place.
  std::size_t throw_round(std::size_t most) {
    const std::size_t before = grid_.points().size();
    for (std::size_t left = cells_.size(); left > 0 && !cells_.empty(); --left) {
      if (grid_.points().size() == most) break;
      throw_dart();
    }
    return grid_.points().size() - before;
  }

  void throw_dart() {
    const auto i =
        static_cast<std::size_t>(stream_.next_unit() * static_cast<double>(cells_.size()));
    const Cell cell = cells_[i];
    const double x = stream_.next_unit();
    const Point2 dart = place_in(cell, x, stream_.next_unit());
    if (!window_.contains(dart)) return;
    std::uint32_t point = grid_.find_near(cell.bucket, [&](const Point2& p) {
      return squared_norm(window_.difference(p, dart)) < squared_distance_;
    });
    if (point == BucketGrid::none) {
      point = static_cast<std::uint32_t>(grid_.points().size());
      grid_.add(dart, cell.bucket);
    }
    // Whichever point is in the way now may have taken the whole cell.
    if (covers(grid_.points()[point], centre(cell))) drop(i);
  }

  /// Halves the cells along their longer side, or quarters them where they are nearly square: in a
  /// window that is low beyond measure, cells as low would only multiply.
  void split_cells() {
    constexpr double nearly_square = 0.75;
    const std::uint32_t across = cell_size_.x >= nearly_square * cell_size_.y ? 2 : 1;
    const std::uint32_t up = cell_size_.y >= nearly_square * cell_size_.x ? 2 : 1;
    halvings_across_ += across == 2;
    halvings_up_ += up == 2;
    set_cell_size();
    std::vector<Cell> parts;
    for (const Cell& cell : cells_)
      for (std::uint32_t row = 0; row < up; ++row)
        for (std::uint32_t column = 0; column < across; ++column) {
          const Cell part{cell.bucket, across * cell.column + column, up * cell.row + row};
          if (may_have_free_ground(part)) parts.push_back(part);
        }
    cells_ = std::move(parts);
    refuse_slivers();
  }

  bool may_have_free_ground(const Cell& cell) const {
    const Point2 middle = centre(cell);
    const auto covers_cell = [&](const Point2& p) { return covers(p, middle); };
    return grid_.find_near(cell.bucket, covers_cell) == BucketGrid::none && touches_window(middle);
  }

  /// A polygon much thinner than the distance would be tiled by cells as small as it is thin.
  void refuse_slivers() const {
    const std::size_t usual = std::size_t{grid_.columns()} * grid_.rows();
    constexpr std::size_t always_allowed = 1'000'000;
    if (cells_.size() > 4 * usual + always_allowed)
      throw InputError("the polygon is too thin to throw darts at; give a wider one");
  }

  const Window& window_;
  BucketGrid grid_;
  double squared_distance_;
  UnitStream& stream_;
  std::vector<Cell> cells_;
  int halvings_across_ = 0;
  int halvings_up_ = 0;
  Point2 cell_size_;            // after these halvings; the same for all
  double half_diagonal_ = 0.0;  // of such a cell
};

/// Points that fit into a box: the jamming density, and half a distance more on every side, as
/// points may stand on an edge.
double points_that_fit(const Rectangle& box, double distance) {
  constexpr double jamming_density = 0.6966;  // 4 / pi * 0.54707, the covered share of jammed discs
  return jamming_density * (box.width() / distance + 1.0) * (box.height() / distance + 1.0);
}

/// Longest side of a bucket: as small as gives each at most one point, but no smaller than `most`
/// points need, as a few points with a tiny distance should not fill the memory with buckets.
double bucket_side(const Window& window, double distance, double most) {
  const Rectangle& box = window.bounding_box();
  constexpr double most_buckets = 2.0 * most_points;  // of a thin polygon in a large box
  return std::max({distance / std::sqrt(2.0), std::sqrt(window.area() / most),
                   std::sqrt(box.area() / most_buckets),
                   std::max(box.width(), box.height()) / std::min(most, most_buckets)});
}

}  // namespace

std::vector<Point2> dart_points(const Window& window, double distance, std::size_t most,
                                UnitStream& stream) {
  PHYTOBENCH_EXPECT(std::isfinite(distance) && distance >= 0.0);
  if (most == 0) return {};
  const auto asked_for = static_cast<double>(most);
  refuse_too_many_points(std::min(asked_for, points_that_fit(window.bounding_box(), distance)),
                         "raise the distance or ask for fewer points");
  const double side = bucket_side(window, distance, asked_for);
  return DartBoard(window, side, distance, stream).throw_until(most);
}

}  // namespace phytobench
