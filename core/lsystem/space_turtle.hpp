// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/lsystem/block_writer.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/segment_stream.hpp"
#include "core/lsystem/turtle_commands.hpp"
#include "core/memory/large_array.hpp"

namespace phytobench {

/// The turtle in space, in a form in which whole drawings can move it.
class SpaceTurtle {
 public:
  using Segment = SpatialSegment;
  /// Where the turtle stands; also how it moves, as where it comes to from the origin with heading
  /// along x, left along y and up along z.
  struct State {
    Vector3 position;
    TurtleFrame frame{.heading = {1, 0, 0}, .left = {0, 1, 0}, .up = {0, 0, 1}};
    std::uint32_t turns = 0;  ///< that have rounded the frame
  };

  explicit SpaceTurtle(const TurtleSettings& settings);

  State start() const { return start_; }
  State motion_of(const TurtleCommand& command) const;
  void move(State& state, const State& motion) const;

  /// Drawings in the frame in which they begin: all x of a drawing, all y, all z.
  class Blocks {
   public:
    std::uint32_t add(std::span<const Segment> drawing);
    std::size_t bytes() const { return coordinates_.size() * sizeof(double); }
    const double* block(std::uint32_t first) const {
      return coordinates_.data() + std::size_t{first} * numbers;
    }

   private:
    static constexpr std::size_t numbers = sizeof(Segment) / sizeof(double);
    LargeVector<double> coordinates_;
  };

  void write(const Blocks& blocks, std::uint32_t first, std::uint32_t count, const State& state,
             Segment* out, Stores) const {
    move_block(blocks.block(first), count, state.frame, state.position, out);
  }

 private:
  State start_;
};

}  // namespace phytobench
