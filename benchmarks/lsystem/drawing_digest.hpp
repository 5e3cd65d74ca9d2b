// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

/// Ends of a segment: from x, y, z and to x, y, z.
template <class Number>
using SegmentEnds = std::array<Number, 6>;

inline SegmentEnds<double> ends_of(const PlanarSegment& s) {
  return {s.from_x, s.from_y, 0.0, s.to_x, s.to_y, 0.0};
}
inline SegmentEnds<double> ends_of(const SpatialSegment& s) {
  return {s.from.x, s.from.y, s.from.z, s.to.x, s.to.y, s.to.z};
}

/// What is left of a drawing when it is judged: segments one by one at its beginning and end, and
/// between them sums over chunks, in which each segment has a weight by its place, so that they
/// tell when two change places. Sums are as exact as long doubles allow.
class DrawingDigest {
 public:
  static constexpr std::uint64_t chunk_segments = 65'536;
  static constexpr std::size_t edge_segments = 4'096;
  using Ends = SegmentEnds<long double>;

  static constexpr std::uint64_t most_weight = 1'021;
  static constexpr std::uint64_t weight(std::uint64_t place) { return place % most_weight + 1; }

  void add(const Ends& ends) {
    if (count_ % chunk_segments == 0) sums_.emplace_back();
    const auto factor = static_cast<long double>(weight(count_));
    for (std::size_t k = 0; k < ends.size(); ++k) sums_.back()[k] += factor * ends[k];
    if (first_.size() < edge_segments)
      first_.push_back(ends);
    else
      last_[count_ % edge_segments] = ends;
    ++count_;
  }
  template <class Segment>
  void add(std::span<const Segment> block) {
    for (const Segment& segment : block) {
      const SegmentEnds<double> ends = ends_of(segment);
      Ends wide;
      std::copy(ends.begin(), ends.end(), wide.begin());
      add(wide);
    }
  }

  std::uint64_t count() const { return count_; }
  const std::vector<Ends>& sums() const { return sums_; }
  const std::vector<Ends>& first() const { return first_; }
  const std::vector<Ends>& last() const { return last_; }  ///< place modulo edge_segments

 private:
  std::uint64_t count_ = 0;
  std::vector<Ends> sums_;
  std::vector<Ends> first_;
  std::vector<Ends> last_ = std::vector<Ends>(edge_segments, Ends{});
};

}  // namespace phytobench
