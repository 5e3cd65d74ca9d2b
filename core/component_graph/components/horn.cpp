// SPDX-License-Identifier: MIT
// A stem, branch or hair: a cone, bent by two relative rotations ([Lintermann1997] sec. 4 and 5.1).
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/stem.hpp"

namespace phytobench::components {

namespace {

Spine spine_of(const ComponentInput& input) {
  const int joints = static_cast<int>(input.values.count(StemKey::segments)) - 1;
  return stem_spine(input.values, [&](const Frame& frame, int joint) {
    return bent(input.values, frame, joint, joints);
  });
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const Spine spine = spine_of(input);
  for (Frame& frame : frames) frame = spine.end();
}

void make_geometry(const ComponentInput& input, std::vector<MeshPart>& parts) {
  add_stem(input, spine_of(input), parts);
}

}  // namespace

extern const ComponentKind horn{
    .name = "horn",
    .summary = "A stem, branch or hair: a bent cone; what follows stands at its end.",
    .source = "[Lintermann1997] sec. 4",
    .keys = stem_keys,
    .place_children = place_children,
    .make_geometry = make_geometry,
};

}  // namespace phytobench::components
