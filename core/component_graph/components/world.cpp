// SPDX-License-Identifier: MIT
// Other fields for photo- and gravitropism of all that follows ([Lintermann1997] sec. 4). The paper
// lets them point along +z and -z; in the suite y is up.
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/key_table.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t { photo, gravi };

constexpr std::array<ComponentKey, 2> keys{{
    {"photo", "-",
     "where light is: a vector for every place x, y, z of the plant before it is deformed, at time "
     "t; only its direction counts, and zero is no light. [\"1 - x\", \"2 - y\", \"-z\"] looks to "
     "the point (1, 2, 0), [\"x\", \"0\", \"z\"] away from the y axis",
     in_section_4, "[\"0\", \"1\", \"0\"]", FieldExpressions{"0", "1", "0"}},
    {"gravi", "-", "where weight pulls, in the same way", in_section_4, "[\"0\", \"-1\", \"0\"]",
     FieldExpressions{"0", "-1", "0"}},
}};

void place_children(const ComponentInput&, LinkKind, std::span<Frame> frames) {
  for (Frame& frame : frames) frame = Frame{};
}

void change_context(const ComponentInput& input, BuildContext& context) {
  context.photo = input.values.field(photo);
  context.gravi = input.values.field(gravi);
}

}  // namespace

extern const ComponentKind world{
    .name = "world",
    .summary = "Gives all that follows other fields of light and weight.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .place_children = place_children,
    .change_context = change_context,
};

}  // namespace phytobench::components
