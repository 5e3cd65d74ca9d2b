// SPDX-License-Identifier: MIT
// A body, or nothing, and a transformation of what follows ([Lintermann1997] sec. 4).
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/component_material.hpp"
#include "core/component_graph/shapes/key_table.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/component_graph/shapes/primitive_shapes.hpp"
#include "core/component_graph/shapes/vertex_limit.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t {
  shape,
  size_x,
  size_y,
  size_z,
  stands,
  corners,
  surface,
  colour,
  move_x,
  move_y,
  move_z,
  turn_x,
  turn_y,
  turn_z,
  scale
};

enum Shape : std::size_t { sphere, cylinder_shape, box_shape, none };
constexpr std::array<std::string_view, 4> shape_words{"sphere", "cylinder", "box", "none"};
enum Stands : std::size_t { on_origin, about_origin };
constexpr std::array<std::string_view, 2> stands_words{"on", "about"};

constexpr std::array<ComponentKey, 15> keys{{
    {"shape", "-", "body; it stays where the component is", in_section_4, "\"sphere\"",
     WordChoice{shape_words, sphere}},
    {"size_x", "length", "of the body along x", own_choice, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"size_y", "length", "of the body along y, its axis", own_choice, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"size_z", "length", "of the body along z", own_choice, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"stands", "-", "\"on\" the origin, or with its middle there: \"about\" it", own_choice,
     "\"on\"", WordChoice{stands_words, on_origin}},
    {"corners", "1", "around a sphere or cylinder", own_choice, "16",
     RangedNumber{corner_counts, 16.0}},
    {"surface", "-", "what it looks like; \"bark\" has streaks", own_choice, "\"plain\"",
     WordChoice{surface_words, 2}},
    {"colour", "-", "of the surface", own_choice, "\"#8a8578\"", ColourValue{"#8a8578"}},
    {"move_x", "length", "what follows is scaled, turned about x, then y, then z, and moved",
     in_section_4, "0.0", RangedNumber{signed_lengths, 0.0}},
    {"move_y", "length", "the same along y", in_section_4, "0.0",
     RangedNumber{signed_lengths, 0.0}},
    {"move_z", "length", "the same along z", in_section_4, "0.0",
     RangedNumber{signed_lengths, 0.0}},
    {"turn_x", "degrees", "turn of what follows about x, from y to z", in_section_4, "0.0",
     RangedNumber{turns, 0.0}},
    {"turn_y", "degrees", "about y, from z to x", in_section_4, "0.0", RangedNumber{turns, 0.0}},
    {"turn_z", "degrees", "about z, from x to y", in_section_4, "0.0", RangedNumber{turns, 0.0}},
    {"scale", "1", "size of what follows", in_section_4, "1.0", RangedNumber{scales, 1.0}},
}};

TriangleMesh mesh_of(const ComponentInput& input, std::size_t word) {
  const ComponentValues& values = input.values;
  const Vector3 half =
      0.5 * Vector3{values.number(size_x), values.number(size_y), values.number(size_z)};
  const Vector3 center{0.0, values.choice(stands) == on_origin ? half.y : 0.0, 0.0};
  if (word == box_shape) return box(center, half);
  const int around = input.context.pieces(static_cast<double>(values.count(corners)), 3);
  refuse_too_many_vertices("a body", around / 2 + 1, around + 1);
  return word == sphere ? ellipsoid(center, half, around) : cylinder(center, half, around);
}

void make_geometry(const ComponentInput& input, std::vector<MeshPart>& parts) {
  const std::size_t word = input.values.choice(shape);
  if (word == none) return;
  parts.push_back({material_of(input.values, surface, colour), mesh_of(input, word)});
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const ComponentValues& values = input.values;
  const auto about = [&](const Vector3& axis, std::size_t key) {
    return Rotation::about(axis, radians(values.number(key)));
  };
  Frame moved = Frame{}
                    .turned(about({1.0, 0.0, 0.0}, turn_x))
                    .turned(about({0.0, 1.0, 0.0}, turn_y))
                    .turned(about({0.0, 0.0, 1.0}, turn_z));
  moved.origin = {values.number(move_x), values.number(move_y), values.number(move_z)};
  moved.scale = values.number(scale);
  for (Frame& frame : frames) frame = moved;
}

}  // namespace

extern const ComponentKind simple{
    .name = "simple",
    .summary = "A sphere, cylinder, box or nothing, and a transformation of what follows.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .place_children = place_children,
    .make_geometry = make_geometry,
};

}  // namespace phytobench::components
