// SPDX-License-Identifier: MIT
// What can be measured on a turtle's drawing: areas, boxes, lengths, repeated segments. Exact on
// whole numbers. Shares no code with core/, so that agreement means something.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/oracles/turtle_2d.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::oracles {

// Twice the area inside of a closed polygon, positive if it runs counterclockwise. The first corner
// may come again at the end.
template <class Point>
auto twice_signed_area(const std::vector<Point>& corners) {
  auto sum = decltype(Point::x){0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// Ends where it began; for drawings without branches.
template <class State>
bool is_closed(const TurtleDrawing<State>& drawing) {
  return drawing.nodes.front() == drawing.nodes.back();
}

template <class Point>
struct Box {
  Point least, greatest;
};

inline Box<SpacePoint> bounding_box(const std::vector<SpacePoint>& points) {
  Box<SpacePoint> box{points.front(), points.front()};
  for (const SpacePoint& p : points) {
    box.least = {std::fmin(box.least.x, p.x), std::fmin(box.least.y, p.y),
                 std::fmin(box.least.z, p.z)};
    box.greatest = {std::fmax(box.greatest.x, p.x), std::fmax(box.greatest.y, p.y),
                    std::fmax(box.greatest.z, p.z)};
  }
  return box;
}

template <class Point>
Box<Point> bounding_box(const std::vector<Point>& points) {
  Box<Point> box{points.front(), points.front()};
  for (const Point& p : points) {
    box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y)};
    box.greatest = {std::max(box.greatest.x, p.x), std::max(box.greatest.y, p.y)};
  }
  return box;
}

inline double length_of(PlanePoint a, PlanePoint b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
inline double length_of(SpacePoint a, SpacePoint b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

template <class State>
double drawn_length(const TurtleDrawing<State>& drawing) {
  double sum = 0;
  for (const auto& segment : drawing.segments) sum += length_of(segment.from, segment.to);
  return sum;
}

// Points that are closer than about a millionth count as one; the grid's are whole already.
inline GridPoint rounded(GridPoint p) {
  return p;
}
inline std::pair<std::int64_t, std::int64_t> rounded(PlanePoint p) {
  return {std::llround(p.x * 1e6), std::llround(p.y * 1e6)};
}
inline std::tuple<std::int64_t, std::int64_t, std::int64_t> rounded(SpacePoint p) {
  return {std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6)};
}

template <class Point>
std::size_t distinct_points(const std::vector<Point>& points) {
  std::set<decltype(rounded(Point{}))> places;
  for (const Point& p : points) places.insert(rounded(p));
  return places.size();
}

// How often each segment is drawn, whichever way; in no particular order.
template <class State>
std::vector<int> segment_repetitions(const TurtleDrawing<State>& drawing) {
  using Place = decltype(rounded(decltype(State::position){}));
  std::map<std::pair<Place, Place>, int> times;
  for (const auto& segment : drawing.segments) {
    const Place a = rounded(segment.from), b = rounded(segment.to);
    ++times[{std::min(a, b), std::max(a, b)}];
  }
  std::vector<int> repetitions;
  for (const auto& [segment, count] : times) repetitions.push_back(count);
  return repetitions;
}

}  // namespace phytobench::oracles
