// SPDX-License-Identifier: MIT
// For tests: stands for a component that somebody adds.
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/key_table.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t { count, distance };

constexpr std::array<ComponentKey, 2> keys{{
    {"count", "1", "children per link", own_choice, "4", RangedNumber{child_counts, 4.0}},
    {"distance", "length", "from one child to the next", own_choice, "1.5",
     RangedNumber{lengths, 1.5}},
}};

std::uint64_t child_count(const ComponentValues& values) {
  return values.count(count);
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const double step = input.values.number(distance);
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].origin = {step * static_cast<double>(i), 0.0, 0.0};
}

}  // namespace

extern const ComponentKind row{
    .name = "row",
    .summary = "Makes children side by side.",
    .source = "own",
    .keys = keys,
    .is_multiplier = true,
    .child_count = child_count,
    .place_children = place_children,
};

}  // namespace phytobench::components
