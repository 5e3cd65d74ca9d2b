// SPDX-License-Identifier: MIT
// Numbers that say what a drawing is, for comparisons with closed forms.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/lsystem/drawing.hpp"

namespace phytobench {

/// Of all segments, added in their order.
double total_length(const Drawing& drawing);

/// Around all segments; polygons left out. Empty if there are none.
BoundingBox segment_box(const Drawing& drawing);

/// Around all corners of polygons. Empty if there are none.
BoundingBox polygon_box(const Drawing& drawing);

/// Whether the segments are one line without a gap, each beginning exactly where the last ended.
bool is_one_line(const Drawing& drawing);

/// From the end of the last segment to the beginning of the first; 0 without segments.
double closing_gap(const Drawing& drawing);

/// Of the polygon that the segments' beginnings are the corners of, seen from +z: positive if it
/// runs counter-clockwise. Means something if is_one_line() and closing_gap() is 0 or nearly so.
double signed_area(const Drawing& drawing);

/// Half the sum of cross products of neighbouring corners: length the area of a plane outline,
/// direction the side from which it runs counter-clockwise. 0 for fewer than three corners.
Vector3 vector_area(std::span<const Vector3> corners);

/// The corners of a polygon.
std::span<const Vector3> corners_of(const Drawing& drawing, const TurtlePolygon& polygon);

/// How many points are different. Two coordinates are the same if no more than `tolerance` lies
/// between them, or if others lie between such that no gap is larger; 0 means equal numbers.
std::size_t distinct_point_count(std::span<const Vector3> points, double tolerance = 0.0);

/// What is different among the segments, directions left out of account.
struct DistinctParts {
  std::size_t segments = 0;
  std::size_t most_often = 0;  ///< how often the segment is drawn that is drawn most often
  std::size_t vertices = 0;    ///< ends of segments
};
/// The same tolerance as distinct_point_count().
DistinctParts distinct_parts(const Drawing& drawing, double tolerance = 0.0);

/// How many nodes have how many children.
std::map<std::size_t, std::size_t> child_counts(const Skeleton& skeleton);

/// Length of the way from the root to each node.
std::vector<double> path_lengths(const Skeleton& skeleton);

/// Positions of the nodes without children, without the root.
std::vector<Vector3> tip_positions(const Skeleton& skeleton);

/// Greatest entry of |R^T R - I| for the matrix of heading, left and up.
double orthonormality_error(const TurtleFrame& frame);

}  // namespace phytobench
