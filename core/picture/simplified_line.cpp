// SPDX-License-Identifier: MIT
#include "core/picture/simplified_line.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace phytobench {

namespace {

/// From a point to the nearest of a piece of a straight line.
double squared_distance_to_piece(const Point2& point, const Point2& from, const Point2& to) {
  const Point2 along = to - from, off = point - from;
  const double length = squared_norm(along);
  if (length == 0.0) return squared_norm(off);
  const double share = std::clamp(dot(off, along) / length, 0.0, 1.0);
  return squared_norm(off - share * along);
}

}  // namespace

std::vector<Point2> simplified_line(const std::vector<Point2>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> pieces{{0, points.size() - 1}};
  while (!pieces.empty()) {
    const auto [first, last] = pieces.back();
    pieces.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t turn = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = squared_distance_to_piece(points[i], points[first], points[last]);
      if (!(distance > farthest)) continue;
      farthest = distance;
      turn = i;
    }
    if (turn == first) continue;
    kept[turn] = true;
    pieces.push_back({first, turn});
    pieces.push_back({turn, last});
  }
  std::vector<Point2> line;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) line.push_back(points[i]);
  return line;
}

}  // namespace phytobench
