// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/contract/check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

using VertexKey = std::array<std::uint32_t, 3>;

/// Numbers the coordinates along one axis such that the same ones have the same number.
template <class Coordinate>
void number_axis(std::span<const Vector3> points, double tolerance, std::size_t axis,
                 Coordinate coordinate, std::vector<VertexKey>& keys) {
  std::vector<std::pair<double, std::uint32_t>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    sorted.emplace_back(coordinate(points[i]), static_cast<std::uint32_t>(i));
  std::sort(sorted.begin(), sorted.end());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i > 0 && sorted[i].first - sorted[i - 1].first > tolerance) ++number;
    keys[sorted[i].second][axis] = number;
  }
}

std::vector<VertexKey> vertex_keys(std::span<const Vector3> points, double tolerance) {
  PHYTOBENCH_EXPECT(tolerance >= 0.0 && points.size() <= 0xffffffffu);
  std::vector<VertexKey> keys(points.size());
  number_axis(
      points, tolerance, 0, [](const Vector3& p) { return p.x; }, keys);
  number_axis(
      points, tolerance, 1, [](const Vector3& p) { return p.y; }, keys);
  number_axis(
      points, tolerance, 2, [](const Vector3& p) { return p.z; }, keys);
  return keys;
}

std::size_t count_distinct(std::vector<VertexKey> keys) {
  std::sort(keys.begin(), keys.end());
  return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

}  // namespace

double total_length(const Drawing& drawing) {
  double sum = 0.0;
  for (const TurtleSegment& segment : drawing.segments) sum += norm(segment.to - segment.from);
  return sum;
}

BoundingBox segment_box(const Drawing& drawing) {
  BoundingBox box;
  for (const TurtleSegment& segment : drawing.segments) {
    box.extend(segment.from);
    box.extend(segment.to);
  }
  return box;
}

BoundingBox polygon_box(const Drawing& drawing) {
  BoundingBox box;
  for (const Vector3& corner : drawing.corners) box.extend(corner);
  return box;
}

bool is_one_line(const Drawing& drawing) {
  for (std::size_t i = 1; i < drawing.segments.size(); ++i)
    if (drawing.segments[i].from != drawing.segments[i - 1].to) return false;
  return true;
}

double closing_gap(const Drawing& drawing) {
  if (drawing.segments.empty()) return 0.0;
  return norm(drawing.segments.front().from - drawing.segments.back().to);
}

double signed_area(const Drawing& drawing) {
  double twice = 0.0;
  for (const TurtleSegment& segment : drawing.segments) {
    // From the first corner, not from the origin: smaller numbers.
    const Vector3 a = segment.from - drawing.segments.front().from;
    const Vector3 b = segment.to - drawing.segments.front().from;
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

Vector3 vector_area(std::span<const Vector3> corners) {
  Vector3 twice;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    twice = twice + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * twice;
}

std::span<const Vector3> corners_of(const Drawing& drawing, const TurtlePolygon& polygon) {
  return std::span<const Vector3>(drawing.corners).subspan(polygon.first, polygon.count);
}

std::size_t distinct_point_count(std::span<const Vector3> points, double tolerance) {
  return count_distinct(vertex_keys(points, tolerance));
}

DistinctParts distinct_parts(const Drawing& drawing, double tolerance) {
  std::vector<Vector3> ends;
  ends.reserve(2 * drawing.segments.size());
  for (const TurtleSegment& segment : drawing.segments) {
    ends.push_back(segment.from);
    ends.push_back(segment.to);
  }
  std::vector<VertexKey> keys = vertex_keys(ends, tolerance);
  std::vector<std::pair<VertexKey, VertexKey>> segments;
  segments.reserve(drawing.segments.size());
  for (std::size_t i = 0; i < keys.size(); i += 2)
    segments.push_back(std::minmax({keys[i], keys[i + 1]}));
  std::sort(segments.begin(), segments.end());
  DistinctParts parts;
  std::size_t first = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == 0 || segments[i] != segments[first]) {
      first = i;
      ++parts.segments;
    }
    parts.most_often = std::max(parts.most_often, i - first + 1);
  }
  parts.vertices = count_distinct(std::move(keys));
  return parts;
}

std::map<std::size_t, std::size_t> child_counts(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::map<std::size_t, std::size_t> counts;
  for (std::size_t node = 0; node < skeleton.node_count(); ++node)
    ++counts[children.of(static_cast<std::int32_t>(node)).size()];
  return counts;
}

std::vector<double> path_lengths(const Skeleton& skeleton) {
  std::vector<double> lengths(skeleton.node_count(), 0.0);
  for (std::size_t node = 1; node < lengths.size(); ++node) {
    const auto parent = static_cast<std::size_t>(skeleton.parents()[node]);
    lengths[node] =
        lengths[parent] + norm(skeleton.positions()[node] - skeleton.positions()[parent]);
  }
  return lengths;
}

std::vector<Vector3> tip_positions(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::vector<Vector3> tips;
  for (std::size_t node = 1; node < skeleton.node_count(); ++node)
    if (children.of(static_cast<std::int32_t>(node)).empty())
      tips.push_back(skeleton.positions()[node]);
  return tips;
}

double orthonormality_error(const TurtleFrame& frame) {
  const Vector3* columns[] = {&frame.heading, &frame.left, &frame.up};
  double worst = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      worst = std::max(worst, std::abs(dot(*columns[i], *columns[j]) - (i == j ? 1.0 : 0.0)));
  return worst;
}

}  // namespace phytobench
