// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle_poses.hpp"

namespace phytobench {

namespace {

/// The smallest number of turns by the angle that makes `full_turns` whole turns.
struct Period {
  std::int64_t turns = 0;
  std::int64_t full_turns = 0;
};

/// Up to the rounding of the angle: 360 / 7 is meant to close after seven turns, and no double
/// comes nearer.
std::optional<Period> period_of(double degrees) {
  constexpr std::int64_t most_turns = 8192;
  for (std::int64_t turns = 1; turns <= most_turns; ++turns) {
    const double turned = static_cast<double>(turns) * degrees;
    if (std::abs(std::remainder(turned, 360.0)) <= 0x1p-52 * std::abs(turned))
      return Period{turns, std::llround(turned / 360.0)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<PlaneTable> PlaneTable::of(const TurtleSettings& turtle, TurtleCommands& commands) {
  if (!commands.planar || commands.turns_by_parameters) return std::nullopt;
  const std::optional<Period> period = period_of(std::remainder(turtle.angle_deg, 360.0));
  if (!period) return std::nullopt;
  PlaneTable table;
  const std::int64_t halves = period->turns % 2 == 0 ? 1 : 2;  // so that | is a heading, too
  const std::int64_t count = period->turns * halves;
  table.count_ = static_cast<std::uint32_t>(count);
  for (TurtleCommand& command : commands.of) {
    if (command.action != TurtleAction::turn) continue;
    const std::int64_t step = (command.sign > 0.0 ? 1 : -1) * period->full_turns * halves % count;
    command.headings = static_cast<std::uint32_t>(step < 0 ? step + count : step);
  }
  for (std::int64_t i = 0; i < count; ++i) {
    const PlaneDirection from_right =
        plane_direction(360.0 * static_cast<double>(i) / static_cast<double>(count));
    const bool upwards = turtle.start == TurtleStart::upwards;
    table.directions_.push_back(upwards ? PlaneDirection{0.0 - from_right.y, from_right.x}
                                        : from_right);
  }
  return table;
}

SpaceFrame::Pose SpaceFrame::start() const {
  Pose pose;
  if (start_ == TurtleStart::local) pose.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return pose;
}

void SpaceFrame::level(Pose& pose) const {
  const Vector3 across = cross({0.0, 1.0, 0.0}, pose.frame.heading);
  constexpr double vertical = 1e-9;
  const double length = norm(across);
  if (length < vertical) return;
  pose.frame.left = across / length;
  pose.frame.up = cross(pose.frame.heading, pose.frame.left);
}

void SpaceFrame::make_orthonormal(TurtleFrame& frame) {
  frame.heading = frame.heading / norm(frame.heading);
  frame.left = frame.left - dot(frame.left, frame.heading) * frame.heading;
  frame.left = frame.left / norm(frame.left);
  frame.up = cross(frame.heading, frame.left);
}

}  // namespace phytobench
