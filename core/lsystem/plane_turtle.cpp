// SPDX-License-Identifier: MIT
#include "core/lsystem/plane_turtle.hpp"

#include <cmath>
#include <numeric>

namespace phytobench {

PlaneHeadings::PlaneHeadings(double angle_deg) : angle_deg_(angle_deg) {
  constexpr std::int64_t most_parts = 7'200;  // of a full turn: angles with two decimals
  constexpr double rounding = 1e-15, most_turns = 1e6;
  if (!(std::abs(angle_deg) <= 360.0 * most_turns)) return;
  for (std::int64_t parts = 1; parts <= most_parts; ++parts) {
    const double angle = angle_deg / 360.0 * static_cast<double>(parts);
    const double whole = std::round(angle);
    if (!(std::abs(angle - whole) <= rounding * std::abs(angle))) continue;
    full_turn_ = std::lcm(parts, std::int64_t{4});
    angle_ = static_cast<std::int64_t>(whole) * (full_turn_ / parts) % full_turn_;
    break;
  }
  directions_.reserve(static_cast<std::size_t>(full_turn_));
  for (std::int64_t k = 0; k < full_turn_; ++k)
    directions_.push_back(
        plane_direction(360.0 * static_cast<double>(k) / static_cast<double>(full_turn_)));
}

PlaneHeadings::Heading PlaneHeadings::of(int angles, int quarters) const {
  if (directions_.empty()) return Heading{angles} * 4 + (quarters & 3);
  const Heading heading = (angles * angle_ + quarters * (full_turn_ / 4)) % full_turn_;
  return heading < 0 ? heading + full_turn_ : heading;
}

PlaneDirection PlaneHeadings::far_direction(Heading heading) const {
  const double turned = std::fmod(static_cast<double>(heading >> 2) * angle_deg_, 360.0);
  return plane_direction(turned + 90.0 * static_cast<double>(heading & 3));
}

PlaneTurtle::PlaneTurtle(const TurtleSettings& settings)
    : headings_(settings.angle_deg),
      start_{.heading = headings_.of(0, settings.start == TurtleStart::upwards ? 1 : 0)} {}

PlaneTurtle::State PlaneTurtle::motion_of(const TurtleCommand& command) const {
  switch (command.action) {
    case TurtleAction::draw:
    case TurtleAction::move:
      return {.x = command.amount};
    case TurtleAction::turn:
      return {.heading = headings_.of(command.sign < 0.0 ? -1 : 1, 0)};
    case TurtleAction::turn_back:
      return {.heading = headings_.of(0, 2)};
    default:
      return {};
  }
}

std::uint32_t PlaneTurtle::Blocks::add(std::span<const Segment> drawing) {
  const auto first = static_cast<std::uint32_t>(segments_.size());
  segments_.insert(segments_.end(), drawing.begin(), drawing.end());
  return first;
}

}  // namespace phytobench
