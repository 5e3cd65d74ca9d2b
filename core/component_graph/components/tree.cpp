// SPDX-License-Identifier: MIT
// A part of a tree: a horn that follows light and weight, with branches along it ([Lintermann1997]
// sec. 4 and 5.2).
#include <algorithm>

#include "core/component_graph/component.hpp"
#include "core/component_graph/instance_identity.hpp"
#include "core/component_graph/shapes/child_placing.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/component_graph/shapes/stem.hpp"
#include "core/component_graph/shapes/tropism.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t {
  photo = StemKey::count,
  gravi,
  crookedness,
  branches,
  branch_from,
  branch_to,
  branch_shift,
  azimuth_step,
  branch_azimuth,
  branch_tilt,
  branch_roll,
  branch_scale
};

constexpr NumberRange share_shifts{.low = -1.0, .high = 1.0};
constexpr NumberRange crookednesses{.low = 0.0, .high = 180.0};

constexpr std::array<ComponentKey, 12> tree_keys{{
    {"phototropism", "degrees",
     "turn towards light over the whole length if at right angles to it; negative: away",
     in_section_4, "0.0", RangedNumber{turns, 0.0}},
    {"gravitropism", "degrees", "the same towards where weight pulls", in_section_4, "0.0",
     RangedNumber{turns, 0.0}},
    {"crookedness", "degrees", "a random turn at each joint, at most", own_choice, "0.0",
     RangedNumber{crookednesses, 0.0}},
    {"branches", "1", "per branch link", in_section_4, "10", RangedNumber{child_counts, 10.0}},
    {"branch_from", "share", "place of the first branch, of the length", in_section_4, "0.3",
     RangedNumber{shares, 0.3}},
    {"branch_to", "share", "place of the last branch", in_section_4, "1.0",
     RangedNumber{shares, 1.0}},
    {"branch_shift", "share", "added to the place of each branch; none leaves the stem", own_choice,
     "0.0", RangedNumber{share_shifts, 0.0, RangeOver::children}},
    {"azimuth_step", "degrees",
     "turn about the stem from one branch to the next; the default is the golden angle", own_choice,
     "137.50776405003785", RangedNumber{turns, golden_angle_deg}},
    {"branch_azimuth", "degrees", "added to the direction of each branch around the stem",
     own_choice, "0.0", RangedNumber{turns, 0.0, RangeOver::children}},
    {"branch_tilt", "degrees", "angle between stem and branch", "[Lintermann1997] sec. 5.2", "45.0",
     RangedNumber{turns, 45.0, RangeOver::children}},
    {"branch_roll", "degrees", "turn of each branch about its own axis", own_choice, "0.0",
     RangedNumber{turns, 0.0, RangeOver::children}},
    {"branch_scale", "1", "size of each branch and all that hangs below it",
     "[Lintermann1997] sec. 5.2", "0.5", RangedNumber{scales, 0.5, RangeOver::children}},
}};

constexpr auto keys = joined(stem_keys, tree_keys);
constexpr ChildPlacingKeys placing{
    .azimuth = branch_azimuth, .tilt = branch_tilt, .roll = branch_roll, .scale = branch_scale};

/// A turn about a random axis across the stem, the same for every resolution.
Frame crooked(const ComponentValues& values, const Frame& frame, int joint) {
  const double most = values.number(crookedness);
  if (most == 0.0) return frame;
  const InstancePlace& place = values.place();
  constexpr std::uint64_t of_joints = 0x6a6f696e7473;  // apart from the functions of parameters
  const std::uint64_t stream = mixed(place.identity ^ of_joints);
  const auto index = 2 * static_cast<std::uint64_t>(joint);
  const Vector3 axis = frame.direction(outward(360.0 * random_unit(place.seed, stream, index)));
  const double turn = most * random_unit(place.seed, stream, index + 1);
  return frame.turned(Rotation::about(axis, radians(turn)));
}

/// Tropisms act along the whole axis: half a piece's share before the first piece and behind the
/// last, so that the directions of the pieces are those at their middles.
Spine spine_of(const ComponentInput& input) {
  const ComponentValues& values = input.values;
  const int segments = static_cast<int>(values.count(StemKey::segments));
  const Tropism tropism{.photo_deg = values.number(photo), .gravi_deg = values.number(gravi)};
  return stem_spine(values, [&, segments](const Frame& before, int joint) {
    const bool is_inner = joint > 0 && joint < segments;
    Frame frame = before;
    if (is_inner) frame = crooked(values, bent(values, frame, joint, segments - 1), joint);
    const Vector3 pull = pull_at(input, frame.origin, tropism);
    return pulled(frame, pull, (is_inner ? 1.0 : 0.5) / segments);
  });
}

void place_branches(const ComponentInput& input, const Spine& spine, std::span<Frame> frames) {
  const ComponentValues& values = input.values;
  const NumberSpan places{values.number(branch_from), values.number(branch_to)};
  const double step = values.number(azimuth_step);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const SiblingNumber number = child_number(i, frames);
    const double share = places.at(number) + values.number_for_child(branch_shift, number);
    const double azimuth = child_azimuth(values, placing, number, step * static_cast<double>(i));
    frames[i] =
        spine.at(std::clamp(share, 0.0, 1.0)) * child_frame(values, placing, number, {}, azimuth);
  }
}

void place_children(const ComponentInput& input, LinkKind link, std::span<Frame> frames) {
  const Spine spine = spine_of(input);
  if (link == LinkKind::branch) return place_branches(input, spine, frames);
  for (Frame& frame : frames) frame = spine.end();
}

void make_geometry(const ComponentInput& input, std::vector<MeshPart>& parts) {
  add_stem(input, spine_of(input), parts);
}

std::uint64_t branch_count(const ComponentValues& values) {
  return values.count(branches);
}

}  // namespace

extern const ComponentKind tree{
    .name = "tree",
    .summary = "A stem that follows light and weight and bears branches along it.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .carries_branches = true,
    .branch_count = branch_count,
    .place_children = place_children,
    .make_geometry = make_geometry,
};

}  // namespace phytobench::components
