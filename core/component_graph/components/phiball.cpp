// SPDX-License-Identifier: MIT
// Children on a part of a sphere by the golden section ([Lintermann1997] sec. 4 and 5.1). The paper
// names the rule and leaves its formulas to others: an azimuth that grows by the golden angle, and
// bands of equal area between two polar angles, each child in the middle of its own.
#include <cmath>

#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/child_placing.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t { count, radius, polar_first, polar_last, azimuth, tilt, roll, scale };

constexpr NumberRange polar_angles{.low = 0.0, .high = 180.0};

constexpr std::array<ComponentKey, 4> phiball_keys{{
    {"count", "1", "children per link", in_section_5, "100", RangedNumber{child_counts, 100.0}},
    {"radius", "length", "of the sphere about the origin; 0: all begin at one point", in_section_5,
     "1.0", RangedNumber{lengths, 1.0}},
    {"polar_first", "degrees", "angle from the axis where the part of the sphere begins",
     in_section_4, "0.0", RangedNumber{polar_angles, 0.0}},
    {"polar_last", "degrees", "angle from the axis where it ends", in_section_4, "180.0",
     RangedNumber{polar_angles, 180.0}},
}};
constexpr auto keys =
    joined(phiball_keys,
           child_placing_keys("turn of each child away from the axis; 0 looks straight outwards",
                              "0.0", 0.0));
constexpr ChildPlacingKeys placing{.azimuth = azimuth, .tilt = tilt, .roll = roll, .scale = scale};

std::uint64_t child_count(const ComponentValues& values) {
  return values.count(count);
}

/// Polar angle of the middle, by area, of band i = 0 ... n - 1.
double polar_angle_deg(double first_deg, double last_deg, std::size_t i, std::size_t n) {
  const double top = std::cos(radians(first_deg)), bottom = std::cos(radians(last_deg));
  const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
  const double height = top + share * (bottom - top);
  return std::acos(height) * (180.0 / std::numbers::pi);
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const ComponentValues& values = input.values;
  const double first = values.number(polar_first), last = values.number(polar_last);
  const double distance = values.number(radius);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const SiblingNumber number = child_number(i, frames);
    const double direction =
        child_azimuth(values, placing, number, golden_angle_deg * static_cast<double>(i));
    const double polar = polar_angle_deg(first, last, i, frames.size());
    const Vector3 place = distance * outward_frame({}, direction, polar).y;
    frames[i] = child_frame(values, placing, number, place, direction, polar);
  }
}

}  // namespace

extern const ComponentKind phiball{
    .name = "phiball",
    .summary = "Makes children on a part of a sphere, placed by the golden section.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .is_multiplier = true,
    .child_count = child_count,
    .place_children = place_children,
};

}  // namespace phytobench::components
