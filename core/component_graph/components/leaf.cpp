// SPDX-License-Identifier: MIT
// A leaf: an outline by a spline, folded, bent and waved ([Lintermann1997] sec. 4 and 5.1).
#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/component_material.hpp"
#include "core/component_graph/shapes/key_table.hpp"
#include "core/component_graph/shapes/leaf_blade.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/component_graph/shapes/tapered_tube.hpp"
#include "core/component_graph/shapes/tropism.hpp"
#include "core/component_graph/shapes/vertex_limit.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t {
  length,
  width,
  outline,
  fold,
  bend,
  wave_height,
  waves,
  petiole_length,
  petiole_radius,
  photo,
  gravi,
  pieces_along,
  pieces_per_half,
  surface,
  colour
};

constexpr std::array default_outline{0.0, 0.62, 0.95, 1.0, 0.88, 0.62, 0.3, 0.0};
constexpr NumberRange folds{.low = -90.0, .high = 90.0};
constexpr NumberRange wave_heights{.low = -10.0, .high = 10.0};
constexpr NumberRange wave_counts{.low = 0.0, .high = 1000.0};
constexpr NumberRange half_widths{.low = 0.0, .high = 100.0};
/// One row would be all that is left of a leaf that is pointed at both ends: nothing.
constexpr int fewest_rows = 2;
constexpr NumberRange row_counts{.low = fewest_rows, .high = 10000.0, .whole = true};

constexpr std::array<ComponentKey, 15> keys{{
    {"length", "length", "of the blade along its middle", in_section_4, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"width", "length", "of the blade where the outline is 1", in_section_4, "0.4",
     RangedNumber{positive_lengths, 0.4}},
    {"outline", "share", "half widths from base to tip, of half the width; a spline joins them",
     in_section_5, "[0.0, 0.62, 0.95, 1.0, 0.88, 0.62, 0.3, 0.0]",
     NumberList{half_widths, default_outline, 2, 1000}},
    {"fold", "degrees", "angle by which each half is lifted along the middle", in_section_4, "10.0",
     RangedNumber{folds, 10.0}},
    {"bend", "degrees", "turn from base to tip, positive to the lower side", in_section_5, "30.0",
     RangedNumber{turns, 30.0}},
    {"wave_height", "share", "of the waves at the edge, of the width there", in_section_5, "0.0",
     RangedNumber{wave_heights, 0.0}},
    {"waves", "1", "along the edge", in_section_5, "3.0", RangedNumber{wave_counts, 3.0}},
    {"petiole_length", "length", "of the stalk below the blade", own_choice, "0.0",
     RangedNumber{lengths, 0.0}},
    {"petiole_radius", "length", "of the stalk", own_choice, "0.01", RangedNumber{lengths, 0.01}},
    {"phototropism", "degrees",
     "turn of the whole leaf towards light if at right angles to it; negative: away", in_section_4,
     "0.0", RangedNumber{turns, 0.0}},
    {"gravitropism", "degrees", "the same towards where weight pulls", in_section_4, "0.0",
     RangedNumber{turns, 0.0}},
    {"pieces_along", "1", "rows of triangles along the blade", own_choice, "8",
     RangedNumber{row_counts, 8.0}},
    {"pieces_per_half", "1", "columns of triangles on each side of the middle", own_choice, "2",
     RangedNumber{NumberRange{.low = 1.0, .high = 1000.0, .whole = true}, 2.0}},
    {"surface", "-", "what it looks like", own_choice, "\"leaf\"", WordChoice{surface_words, 1}},
    {"colour", "-", "of the surface", own_choice, "\"#457d29\"", ColourValue{"#457d29"}},
}};

LeafBlade blade_of(const ComponentInput& input) {
  const ComponentValues& values = input.values;
  const auto pieces = [&](std::size_t key, int fewest) {
    return input.context.pieces(static_cast<double>(values.count(key)), fewest);
  };
  LeafBlade blade;
  blade.length = values.number(length);
  blade.width = values.number(width);
  blade.outline = values.list(outline);
  blade.fold_rad = radians(values.number(fold));
  blade.bend_rad = radians(values.number(bend));
  blade.wave_height = values.number(wave_height);
  blade.waves = values.number(waves);
  blade.pieces_along = pieces(pieces_along, fewest_rows);
  blade.pieces_per_half = pieces(pieces_per_half, 1);
  return blade;
}

/// Where the stalk begins: turned as a whole by the tropisms.
Frame base_of(const ComponentInput& input) {
  const Tropism tropism{.photo_deg = input.values.number(photo),
                        .gravi_deg = input.values.number(gravi)};
  return orthonormal(pulled(Frame{}, pull_at(input, {}, tropism), 1.0));
}

Frame blade_base(const ComponentInput& input) {
  Frame base = base_of(input);
  base.origin = input.values.number(petiole_length) * base.y;
  return base;
}

TriangleMesh petiole(const ComponentInput& input) {
  const double stalk = input.values.number(petiole_length);
  const double radius = input.values.number(petiole_radius);
  if (stalk == 0.0 || radius == 0.0) return {};
  const std::array rings{base_of(input), blade_base(input)};
  return tapered_tube(rings, std::array{radius, radius},
                      {.corners = input.context.pieces(4.0, 3), .caps = TubeCaps::none});
}

void make_geometry(const ComponentInput& input, std::vector<MeshPart>& parts) {
  const Frame base = blade_base(input);
  const LeafBlade blade = blade_of(input);
  refuse_too_many_vertices("a leaf", 2 * (blade.pieces_along + 1), 2 * blade.pieces_per_half + 1);
  TriangleMesh mesh = mesh_blade(blade);
  for (Vector3& place : mesh.positions) place = base.place(place);
  for (Vector3& normal : mesh.normals) normal = base.direction(normal);
  append(mesh, petiole(input));
  parts.push_back({material_of(input.values, surface, colour), std::move(mesh)});
}

void place_children(const ComponentInput& input, LinkKind, std::span<Frame> frames) {
  const Frame tip = blade_base(input) * blade_middle(blade_of(input), 1.0);
  for (Frame& frame : frames) frame = orthonormal(tip);
}

}  // namespace

extern const ComponentKind leaf{
    .name = "leaf",
    .summary = "A leaf with an outline by a spline, folded, bent and waved; both sides are meshed.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .place_children = place_children,
    .make_geometry = make_geometry,
};

}  // namespace phytobench::components
