// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_grid_colonization.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace phytobench::oracles::brzoska2019 {

namespace {

bool finite(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool all_finite(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), finite);
}

// A length whose square, as computed, exceeds d * d, as computed: also where that underflows to 0.
// Then a point that differs by it in one coordinate is out: rounding keeps the order of
// differences, squares and sums.
double reach_of(double d) {
  return std::sqrt(d * d) * (1 + 1e-9) + 1e-150;
}

}  // namespace

PointGrid::PointGrid(const std::vector<Point>& points, double distance) {
  choose_cells(points, distance);
  // Count the points of every cell, and sum up to where each cell begins.
  begin_.assign(axes_[0].cells * axes_[1].cells * axes_[2].cells + 1, 0);
  for (Point p : points) ++begin_[cell_of(p) + 1];
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  // Put every point into the next free place of its cell.
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  entries_.resize(points.size());
  for (std::size_t s = 0; s < points.size(); ++s)
    entries_[next[cell_of(points[s])]++] = {points[s], static_cast<int>(s)};
}

void PointGrid::choose_cells(const std::vector<Point>& points, double distance) {
  // One cell where there is nothing to divide by: every search then visits every point.
  if (points.empty() || !all_finite(points)) return;
  Point low = points[0], high = points[0];
  for (Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Point extent = minus(high, low);
  double edge = reach_of(distance);
  if (!finite(extent) || !std::isfinite(edge)) return;
  // Widen the cells until there are no more of them than points.
  const auto cells_along = [&edge](double length) { return std::floor(length / edge) + 1; };
  const auto number = static_cast<double>(points.size());
  while (cells_along(extent.x) * cells_along(extent.y) * cells_along(extent.z) > number) edge *= 2;
  axes_[0] = {low.x, static_cast<std::size_t>(cells_along(extent.x))};
  axes_[1] = {low.y, static_cast<std::size_t>(cells_along(extent.y))};
  axes_[2] = {low.z, static_cast<std::size_t>(cells_along(extent.z))};
  edge_ = edge;
}

// Never decreases with the coordinate, since no step of it does, rounding included. What lies
// outside the box belongs to its outermost cells.
std::size_t PointGrid::cell_along(std::size_t axis, double coordinate) const {
  const std::size_t last = axes_[axis].cells - 1;
  const double cell = std::floor((coordinate - axes_[axis].low) / edge_);
  if (!(cell > 0)) return 0;
  return cell < static_cast<double>(last) ? static_cast<std::size_t>(cell) : last;
}

std::size_t PointGrid::cell_of(Point p) const {
  return (cell_along(0, p.x) * axes_[1].cells + cell_along(1, p.y)) * axes_[2].cells +
         cell_along(2, p.z);
}

// A point that is not out lies strictly between coordinate - reach and coordinate + reach, so not
// outside these sums as rounded, and its cell not outside theirs. No fuzz is needed.
PointGrid::Range PointGrid::cells_around(std::size_t axis, double coordinate, Point centre,
                                         double d) const {
  // Nothing is out of an infinite square, and nothing is known of a distance that is no number.
  if (!(d * d < std::numeric_limits<double>::infinity()) || !finite(centre))
    return {0, axes_[axis].cells - 1};
  const double reach = reach_of(d);
  return {cell_along(axis, coordinate - reach), cell_along(axis, coordinate + reach)};
}

GridJudge::GridJudge(std::vector<Point> attraction_points, double d_i, double theta_rad)
    : points_(std::move(attraction_points)),
      d_i_(d_i),
      theta_rad_(theta_rad),
      cos_half_theta_(std::cos(theta_rad / 2)),
      grid_(points_, d_i),
      live_points_(points_.size()),
      removed_(points_.size(), 0),
      nearest_(points_.size(), -1),
      shortest_(points_.size(), 0) {}

bool GridJudge::perceives(std::size_t v, Point p, double distance) const {
  if (theta_rad_ / 2 >= std::numbers::pi) return true;
  return scalar_product(directions_[v], minus(p, nodes_[v])) >= cos_half_theta_ * distance;
}

// One turn of the loop in recompute(), for a node that comes after all others.
void GridJudge::offer(std::size_t v, const PointGrid::Entry& entry) {
  const double squared = equation_24(entry.position, nodes_[v]);
  if (squared > d_i_ * d_i_) return;
  const auto s = static_cast<std::size_t>(entry.point);
  if (removed_[s]) return;
  if (nearest_[s] >= 0 && squared >= shortest_[s]) return;
  if (!perceives(v, entry.position, std::sqrt(squared))) return;
  nearest_[s] = static_cast<int>(v);
  shortest_[s] = squared;
}

const std::vector<int>& GridJudge::associate(const std::vector<Point>& new_nodes,
                                             const std::vector<Point>& directions) {
  if (new_nodes.size() != directions.size())
    throw std::invalid_argument("as many directions as nodes are needed: one belongs to each");
  // Nodes never move and points only leave, so only a new node can change an answer.
  for (std::size_t k = 0; k < new_nodes.size(); ++k) {
    const std::size_t v = nodes_.size();
    nodes_.push_back(new_nodes[k]);
    directions_.push_back(directions[k]);
    grid_.visit_around(nodes_[v], d_i_, [&](const PointGrid::Entry& entry) { offer(v, entry); });
  }
  return nearest_;
}

std::vector<int> GridJudge::remove(const std::vector<Point>& killers, double d_c) {
  std::vector<int> removed;
  for (Point killer : killers)
    grid_.visit_around(killer, d_c, [&](const PointGrid::Entry& entry) {
      const auto s = static_cast<std::size_t>(entry.point);
      if (!(equation_24(entry.position, killer) <= d_c * d_c) || removed_[s]) return;
      removed_[s] = 1;
      nearest_[s] = -1;
      removed.push_back(entry.point);
    });
  live_points_ -= removed.size();
  std::sort(removed.begin(), removed.end());
  return removed;
}

int GridJudge::recompute(std::size_t point) const {
  if (removed_[point]) return -1;
  const Point p = points_[point];
  int nearest = -1;
  double shortest = 0;
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    const double squared = equation_24(p, nodes_[v]);
    if (squared > d_i_ * d_i_) continue;
    if (nearest >= 0 && squared >= shortest) continue;
    if (!perceives(v, p, std::sqrt(squared))) continue;
    nearest = static_cast<int>(v);
    shortest = squared;
  }
  return nearest;
}

}  // namespace phytobench::oracles::brzoska2019
