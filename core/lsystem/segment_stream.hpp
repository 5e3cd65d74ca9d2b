// SPDX-License-Identifier: MIT
// From a deterministic, context-free system without parameters straight to segments: what a symbol
// draws in k steps is drawn once and then only moved and turned, and the word is never built.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/geometry/vector3.hpp"
#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// A drawn segment in the plane.
struct PlanarSegment {
  double from_x, from_y, to_x, to_y;
};

/// A drawn segment in space.
struct SpatialSegment {
  Vector3 from, to;
};

/// Takes segments in drawing order, block by block; a block is only valid during the call.
template <class Segment>
using SegmentSink = std::function<void(std::span<const Segment>)>;

/// What such a system draws after so many steps: the segments of draw(), in its order, up to the
/// rounding of sums, and exactly those where the angle is a multiple of 90 degrees and the sums of
/// steps are exact. Symbols for widths and colours, and polygons, do not change where segments lie
/// and are passed over: nested polygons are no error here.
class SegmentStream {
 public:
  /// Throws InputError with the objection_to_streaming(), if there is one, and if steps are
  /// negative or more than two million divided by the number of symbols.
  SegmentStream(const LSystem& system, int steps);
  ~SegmentStream();
  SegmentStream(SegmentStream&&) noexcept;
  SegmentStream& operator=(SegmentStream&&) noexcept;

  bool planar() const;                  ///< no symbol leaves the plane
  std::uint64_t segment_count() const;  ///< up to 2^64 - 1, and then that
  std::uint64_t module_count() const;   ///< of the word that is not built; the same
  std::size_t block_bytes() const;      ///< of the drawings kept

  /// All return the parts of drawings that they went through: kept drawings, and moves and turns
  /// between them; 0 unless counts_inner_loop.
  ///
  /// planar() only. A sink that throws ends it.
  std::uint64_t stream(const SegmentSink<PlanarSegment>& sink) const;
  /// `out` holds segment_count(). The same bits for any number of threads, and as stream().
  std::uint64_t write(std::span<PlanarSegment> out, int threads) const;
  /// Any system; a planar one at z = 0.
  std::uint64_t stream(const SegmentSink<SpatialSegment>& sink) const;
  std::uint64_t write(std::span<SpatialSegment> out, int threads) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Why SegmentStream does not take the system; empty if it does. It takes D0L-systems without % and
/// $, which depend on more than the symbol, whose brackets stay as they are.
std::string objection_to_streaming(const LSystem& system);

}  // namespace phytobench
