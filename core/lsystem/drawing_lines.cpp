// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_lines.hpp"

#include <bit>
#include <unordered_map>

namespace phytobench {

namespace {

/// Where a line of a style ends.
struct LineEnd {
  std::uint64_t style;
  Vector3 point;

  friend bool operator==(const LineEnd&, const LineEnd&) = default;
};

struct HashOfEnd {
  std::size_t operator()(const LineEnd& end) const {
    std::uint64_t hash = end.style;
    for (const double value : {end.point.x, end.point.y, end.point.z}) {
      // + 0.0 makes -0 and 0, which are equal, the same bits.
      hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

}  // namespace

std::vector<DrawnLine> drawn_lines(
    const Drawing& drawing, const std::function<std::uint64_t(const TurtleSegment&)>& style_of) {
  std::vector<DrawnLine> lines;
  std::unordered_map<LineEnd, std::size_t, HashOfEnd> open;  // looked up only, never walked
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    const TurtleSegment& segment = drawing.segments[i];
    const std::uint64_t style = style_of(segment);
    std::size_t line = lines.size();
    if (const auto found = open.find({style, segment.from}); found != open.end()) {
      line = found->second;
      open.erase(found);
    } else {
      lines.push_back({style, {segment.from}, {}});
    }
    lines[line].points.push_back(segment.to);
    lines[line].segments.push_back(static_cast<std::uint32_t>(i));
    open.insert_or_assign({style, segment.to}, line);
  }
  return lines;
}

}  // namespace phytobench
