// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

/// What an engine needed for a drawing, independent of the machine.
struct DrawingWork {
  std::uint64_t bytes_held = 0;    ///< at once, at most, beside the segments
  std::uint64_t modules_made = 0;  ///< of all words but the axiom; 0 where none is built
  /// Drawings that were known and only moved, and what lies between them; only with
  /// counts_inner_loop.
  std::uint64_t parts_taken = 0;
};

/// One way to derive a system and to draw it. Interchangeable: every engine draws the same segments
/// in the same order, up to the rounding of sums.
struct DerivationEngine {
  std::string_view name;               ///< that of its file
  std::string_view summary;            ///< one sentence
  std::string_view source;             ///< "[Liebemann2017] sec. 4.2", or whose idea it is
  bool uses_threads = false;           ///< false: runs on one, whatever it is given
  bool uses_threads_to_write = false;  ///< the same for write and write_planar
  std::string_view missing_package = {};
  /// Empty if it can do the system, else why not.
  std::string (*objection)(const LSystem& system) = nullptr;
  /// Hands over the segments, each call with few enough to stay in a cache.
  DrawingWork (*draw)(const LSystem& system, int steps, int threads,
                      const SegmentSink<SpatialSegment>& sink) = nullptr;
  /// Only for systems in the plane.
  DrawingWork (*draw_planar)(const LSystem& system, int steps, int threads,
                             const SegmentSink<PlanarSegment>& sink) = nullptr;
  /// Writes all of them, which are as many as `out` holds. Missing: nothing is faster than to copy
  /// what draw and draw_planar hand over.
  DrawingWork (*write)(const LSystem& system, int steps, int threads,
                       std::span<SpatialSegment> out) = nullptr;
  DrawingWork (*write_planar)(const LSystem& system, int steps, int threads,
                              std::span<PlanarSegment> out) = nullptr;

  bool built() const { return draw != nullptr; }
};

/// Every engine of derivation_engines.def in that order.
std::span<const DerivationEngine* const> all_derivation_engines();

/// The built engine of that name. Throws InputError naming the known ones.
const DerivationEngine& derivation_engine_named(std::string_view name);

}  // namespace phytobench
