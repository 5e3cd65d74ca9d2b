// SPDX-License-Identifier: MIT
// Children on a circle about the axis ([Lintermann1997] sec. 4).
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/child_placing.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t { count, radius, sweep, azimuth, tilt, roll, scale };

constexpr std::array<ComponentKey, 3> ring_keys{{
    {"count", "1", "children per link", in_section_4, "6", RangedNumber{child_counts, 6.0}},
    {"radius", "length", "of the circle on which each child begins", own_choice, "0.5",
     RangedNumber{signed_lengths, 0.5, RangeOver::children}},
    {"sweep", "degrees", "they share it: each is turned on by sweep / count", own_choice, "360.0",
     RangedNumber{turns, 360.0}},
}};
constexpr auto keys = joined(
    ring_keys,
    child_placing_keys("angle between the axis and each child; 90 looks outwards", "90.0", 90.0));
constexpr ChildPlacingKeys placing{.azimuth = azimuth, .tilt = tilt, .roll = roll, .scale = scale};

std::uint64_t child_count(const ComponentValues& values) {
  return values.count(count);
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const ComponentValues& values = input.values;
  const double step = values.number(sweep) / static_cast<double>(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const SiblingNumber number = child_number(i, frames);
    const double direction = child_azimuth(values, placing, number, step * static_cast<double>(i));
    const Vector3 origin = values.number_for_child(radius, number) * outward(direction);
    frames[i] = child_frame(values, placing, number, origin, direction);
  }
}

}  // namespace

extern const ComponentKind ring{
    .name = "ring",
    .summary = "Makes children on a circle, looking outwards.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .is_multiplier = true,
    .child_count = child_count,
    .place_children = place_children,
};

}  // namespace phytobench::components
