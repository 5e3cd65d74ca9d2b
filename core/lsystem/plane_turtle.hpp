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

/// Headings as whole numbers, so that turning is exact. Where the angle is a fraction of a full
/// turn with a small denominator (all with two decimals are), directions come from a table.
class PlaneHeadings {
 public:
  using Heading = std::int64_t;

  explicit PlaneHeadings(double angle_deg);

  /// So many angles to the left, and so many quarters of a full turn.
  Heading of(int angles, int quarters) const;

  Heading sum(Heading a, Heading b) const {
    if (!directions_.empty()) {
      const Heading heading = a + b;
      return heading < full_turn_ ? heading : heading - full_turn_;
    }
    return (((a >> 2) + (b >> 2)) * 4) | ((a + b) & 3);
  }
  PlaneDirection direction(Heading heading) const {
    return directions_.empty() ? far_direction(heading)
                               : directions_[static_cast<std::size_t>(heading)];
  }

 private:
  PlaneDirection far_direction(Heading heading) const;

  double angle_deg_;
  Heading full_turn_ = 0;  ///< headings in it; 0: four times the angles, plus the quarters
  Heading angle_ = 0;
  std::vector<PlaneDirection> directions_;  ///< empty if the angle is no such fraction
};

/// The turtle in the plane, in a form in which whole drawings can move it.
class PlaneTurtle {
 public:
  using Segment = PlanarSegment;
  /// Where the turtle stands; also how it moves, as where it comes to from the origin.
  struct State {
    double x = 0.0;
    double y = 0.0;
    PlaneHeadings::Heading heading = 0;
  };

  explicit PlaneTurtle(const TurtleSettings& settings);

  State start() const { return start_; }
  State motion_of(const TurtleCommand& command) const;

  void move(State& state, const State& motion) const {
    const PlaneDirection d = headings_.direction(state.heading);
    // In the order of move_block(): a drawing ends where the turtle stands.
    const double x = (d.x * motion.x + -d.y * motion.y) + state.x;
    const double y = (d.x * motion.y + d.y * motion.x) + state.y;
    state = {x, y, headings_.sum(state.heading, motion.heading)};
  }

  /// Drawings in the frame in which they begin.
  class Blocks {
   public:
    std::uint32_t add(std::span<const Segment> drawing);
    std::size_t bytes() const { return segments_.size() * sizeof(Segment); }
    std::span<const Segment> block(std::uint32_t first, std::uint32_t count) const {
      return std::span(segments_).subspan(first, count);
    }

   private:
    LargeVector<Segment> segments_;
  };

  void write(const Blocks& blocks, std::uint32_t first, std::uint32_t count, const State& state,
             Segment* out, Stores stores) const {
    move_block(blocks.block(first, count), headings_.direction(state.heading), state.x, state.y,
               out, stores);
  }

 private:
  PlaneHeadings headings_;
  State start_;
};

}  // namespace phytobench
