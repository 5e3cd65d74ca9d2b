// SPDX-License-Identifier: MIT
#include "core/lsystem/space_turtle.hpp"

namespace phytobench {

namespace {

/// Rounding makes a frame's vectors lose length and right angles, a little with each turn.
constexpr std::uint32_t turns_between_repairs = 32;

TurtleFrame orthonormal(const TurtleFrame& frame) {
  const Vector3 heading = frame.heading / norm(frame.heading);
  const Vector3 left = frame.left - dot(frame.left, heading) * heading;
  const Vector3 left_unit = left / norm(left);
  return {heading, left_unit, cross(heading, left_unit)};
}

/// In the order of move_block(): a drawing ends where the turtle stands.
Vector3 turned(const TurtleFrame& frame, const Vector3& v) {
  return (v.x * frame.heading + v.y * frame.left) + v.z * frame.up;
}

}  // namespace

SpaceTurtle::SpaceTurtle(const TurtleSettings& settings) {
  if (settings.start == TurtleStart::upwards) start_.frame = TurtleFrame{};
}

/// As the turtle does it, in its own frame.
SpaceTurtle::State SpaceTurtle::motion_of(const TurtleCommand& command) const {
  State motion;
  TurtleFrame& frame = motion.frame;
  switch (command.action) {
    case TurtleAction::draw:
    case TurtleAction::move:
      motion.position.x = command.amount;
      return motion;
    case TurtleAction::turn:
    case TurtleAction::turn_back: {
      const bool half = command.action == TurtleAction::turn_back;
      const auto [c, s] = plane_direction(half ? 180.0 : command.amount);
      frame.heading = {c, s, 0};
      frame.left = {-s, c, 0};
      break;
    }
    case TurtleAction::pitch: {
      const auto [c, s] = plane_direction(command.amount);
      frame.heading = {c, 0, -s};
      frame.up = {s, 0, c};
      break;
    }
    case TurtleAction::roll: {
      const auto [c, s] = plane_direction(command.amount);
      frame.left = {0, c, -s};
      frame.up = {0, s, c};
      break;
    }
    default:
      return motion;
  }
  motion.turns = 1;
  return motion;
}

void SpaceTurtle::move(State& state, const State& motion) const {
  state.position = turned(state.frame, motion.position) + state.position;
  if (motion.turns == 0) return;
  state.frame = {turned(state.frame, motion.frame.heading), turned(state.frame, motion.frame.left),
                 turned(state.frame, motion.frame.up)};
  if (++state.turns % turns_between_repairs == 0) state.frame = orthonormal(state.frame);
}

std::uint32_t SpaceTurtle::Blocks::add(std::span<const Segment> drawing) {
  const auto first = static_cast<std::uint32_t>(coordinates_.size() / numbers);
  for (double Vector3::*axis : {&Vector3::x, &Vector3::y, &Vector3::z})
    for (const Segment& segment : drawing) {
      coordinates_.push_back(segment.from.*axis);
      coordinates_.push_back(segment.to.*axis);
    }
  return first;
}

}  // namespace phytobench
