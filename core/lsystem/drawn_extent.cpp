// SPDX-License-Identifier: MIT
#include "core/lsystem/drawn_extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract/errors.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench {

namespace {

constexpr std::uint64_t segments_between = std::uint64_t{1} << 22;

/// Asks each time another four million segments are through.
class Pauses {
 public:
  explicit Pauses(const DrawnProgress& progress) : progress_(progress) {}

  void after(std::uint64_t segments) {
    if (segments < next_) return;
    next_ = segments + segments_between;
    if (progress_ && !progress_(segments)) throw Interrupted("the drawing is not finished");
  }

 private:
  const DrawnProgress& progress_;
  std::uint64_t next_ = segments_between;
};

struct ExtentActor : TurtleActor {
  explicit ExtentActor(const DrawnProgress& progress) : pauses(progress) {}

  void segment(const Vector3& from, const Vector3& to, const TurtlePen&, Mark&) {
    ++extent.segments;
    extent.length += norm(to - from);
    extent.segment_box.extend(from);
    extent.segment_box.extend(to);
    pauses.after(extent.segments);
  }
  void open_polygon(const TurtlePen&) { ++extent.polygons; }
  void corner(const Vector3& position) { extent.polygon_box.extend(position); }

  DrawnExtent extent;
  Pauses pauses;
};

/// Squares and corners of the box in numbers of their own, which the compiler can take in vectors.
struct PlanarExtent {
  double length = 0.0;
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x;
  double high_x = -low_x, high_y = -low_x;

  void add(std::span<const PlanarSegment> segments) {
    for (const PlanarSegment& s : segments) {
      const double x = s.to_x - s.from_x, y = s.to_y - s.from_y;
      length += std::sqrt(x * x + y * y);
      low_x = std::min({low_x, s.from_x, s.to_x});
      low_y = std::min({low_y, s.from_y, s.to_y});
      high_x = std::max({high_x, s.from_x, s.to_x});
      high_y = std::max({high_y, s.from_y, s.to_y});
    }
  }
};

DrawnExtent planar_extent(const SegmentStream& stream, Pauses& pauses) {
  DrawnExtent extent;
  PlanarExtent planar;
  stream.stream([&](std::span<const PlanarSegment> segments) {
    planar.add(segments);
    extent.segments += segments.size();
    pauses.after(extent.segments);
  });
  extent.length = planar.length;
  if (extent.segments == 0) return extent;
  extent.segment_box.extend({planar.low_x, planar.low_y, 0.0});
  extent.segment_box.extend({planar.high_x, planar.high_y, 0.0});
  return extent;
}

}  // namespace

DrawnExtent drawn_extent(const LSystem& system, const Word& word, const DrawnProgress& progress) {
  TurtleCommands commands = turtle_commands(system);
  ExtentActor actor(progress);
  interpret(system, commands, word, actor);
  return actor.extent;
}

DrawnExtent drawn_extent(const SegmentStream& stream, const DrawnProgress& progress) {
  Pauses pauses(progress);
  if (stream.planar()) return planar_extent(stream, pauses);
  DrawnExtent extent;
  stream.stream([&](std::span<const SpatialSegment> segments) {
    for (const SpatialSegment& s : segments) {
      extent.length += norm(s.to - s.from);
      extent.segment_box.extend(s.from);
      extent.segment_box.extend(s.to);
    }
    extent.segments += segments.size();
    pauses.after(extent.segments);
  });
  return extent;
}

}  // namespace phytobench
