// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/horizon.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/terrain/shadow/line_sweep.hpp"

namespace phytobench {

namespace {

/// A point of a line: how far towards the heading, and how high, both m; and how many rows had been
/// passed before.
struct LinePoint {
  double along;
  double height;
  int swept;
};

double slope(const LinePoint& from, const LinePoint& to) {
  return (to.height - from.height) / (to.along - from.along);
}

/// The upper hull of what a line has met, the nearest point last.
class LineHull {
 public:
  void clear() { points_.clear(); }
  bool is_empty() const { return points_.empty(); }
  /// Where the rise is steepest from a point nearer than all of the hull, which is not empty:
  /// slopes to its points rise up to there and fall behind, and the place is mostly near its end.
  const LinePoint& steepest_from(const LinePoint& point) const {
    std::size_t i = points_.size() - 1;
    double best = slope(point, points_[i]);
    for (; i > 0; --i) {
      const double next = slope(point, points_[i - 1]);
      if (next < best) break;
      best = next;
    }
    return points_[i];
  }
  void add(const LinePoint& point) {
    while (points_.size() > 1 &&
           slope(point, points_[points_.size() - 2]) >= slope(point, points_[points_.size() - 1]))
      points_.pop_back();
    points_.push_back(point);
  }

 private:
  std::vector<LinePoint> points_;
};

/// Lines towards a heading that lies nearer to the direction of columns, a few at a time.
class HorizonLines {
 public:
  HorizonLines(const HeightField& field, const Heading& heading, const HorizonOptions& options)
      : field_(field),
        rows_(field, {heading.east, heading.south, 0.0}),
        along_column_(field.cell_width() * heading.east / std::hypot(heading.east, heading.south)),
        along_row_(field.cell_depth() * heading.south / std::hypot(heading.east, heading.south)),
        earth_radius_(options.earth_radius) {}

  std::vector<double> tangents() {
    std::vector<double> result(field_.size(), -std::numeric_limits<double>::infinity());
    const auto lines = static_cast<std::ptrdiff_t>(rows_.lines());
    for (std::ptrdiff_t first = 0; first < lines; first += at_once) {
      for (LineHull& hull : hulls_) hull.clear();
      const std::ptrdiff_t end = std::min(first + at_once, lines);
      for (int swept = 0; swept < rows_.count(); ++swept) pass(swept, first, end, result);
    }
    return result;
  }

 private:
  static constexpr std::ptrdiff_t at_once = 16;

  /// Row `swept` seen from the vertices beside the lines [first, end), which then meet it.
  void pass(int swept, std::ptrdiff_t first, std::ptrdiff_t end, std::vector<double>& result) {
    const double lag = rows_.lag(swept), aside = lag - std::floor(lag);
    const std::ptrdiff_t to_column =
        -rows_.first_line() - static_cast<std::ptrdiff_t>(std::floor(lag));
    for (std::ptrdiff_t line = first; line < end; ++line) {
      LineHull& hull = hulls_[static_cast<std::size_t>(line - first)];
      const std::ptrdiff_t column = line + to_column;
      const LinePoint met = point(static_cast<double>(column) - aside, swept);
      if (!hull.is_empty()) {
        see(hull, met, column, swept, true, result);
        if (aside > 0.0) see(hull, met, column - 1, swept, false, result);
      }
      if (!std::isnan(met.height)) hull.add(met);
    }
  }

  /// What the line shows a vertex beside it: where it rises most steeply from where it passes the
  /// vertex, the vertex' own ray is looked at; and in the nearest row, which one of two lines does.
  void see(const LineHull& hull, const LinePoint& met, std::ptrdiff_t column, int swept,
           bool looks_near, std::vector<double>& result) const {
    if (column < 0 || column >= field_.columns()) return;
    const LinePoint vertex = point(static_cast<double>(column), swept);
    double& seen = result[field_.index(static_cast<int>(column), rows_.place(swept))];
    const auto look_at = [&](int passed) {
      const double at = static_cast<double>(column) + rows_.lag(swept) - rows_.lag(passed);
      // A curved Earth was made flat by the drop from the origin; the horizon turns by its arc.
      const double rise = slope(vertex, point(at, passed)) + vertex.along / earth_radius_;
      if (rise > seen) seen = rise;
    };
    const LinePoint& steepest = hull.steepest_from(std::isnan(met.height) ? vertex : met);
    look_at(steepest.swept);
    if (looks_near && steepest.swept != swept - 1) look_at(swept - 1);
    if (std::isnan(vertex.height)) seen = vertex.height;
  }
  /// The surface in the row that comes after `swept` others. Without a height where that is not on
  /// the map, or beside a vertex without data.
  LinePoint point(double column, int swept) const {
    const int row = rows_.place(swept);
    const double along = column * along_column_ + row * along_row_;
    return {along, height(column, row) - along * along / (2.0 * earth_radius_), swept};
  }
  double height(double column, int row) const {
    // What rounding has moved off a vertex.
    const double whole = std::nearbyint(column);
    if (std::abs(column - whole) < 1e-9) column = whole;
    if (!(column >= 0.0 && column <= field_.columns() - 1)) return HeightField::no_data;
    const int before = static_cast<int>(column);
    const double a = field_.at(before, row), part = column - before;
    return part == 0.0 ? a : a + part * (field_.at(before + 1, row) - a);
  }

  const HeightField& field_;
  SweepRows rows_;
  double along_column_;  ///< m towards the heading from one column to the next
  double along_row_;
  double earth_radius_;
  std::array<LineHull, at_once> hulls_;
};

}  // namespace

std::vector<double> horizon_tangents(const HeightField& field, const Heading& heading,
                                     const HorizonOptions& options) {
  PHYTOBENCH_EXPECT(heading.east != 0.0 || heading.south != 0.0);
  PHYTOBENCH_EXPECT(options.earth_radius > 0.0);
  if (!is_sideways(field, {heading.east, heading.south, 0.0}))
    return HorizonLines(field, heading, options).tangents();
  const HeightField exchanged = transposed(field);
  const std::vector<double> tangents =
      HorizonLines(exchanged, {heading.south, heading.east}, options).tangents();
  std::vector<double> result(tangents.size());
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 0; column < field.columns(); ++column)
      result[field.index(column, row)] = tangents[exchanged.index(row, column)];
  return result;
}

}  // namespace phytobench
