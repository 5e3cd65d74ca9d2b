// SPDX-License-Identifier: MIT
// Free-form deformation of all that follows, or of some of it ([Lintermann1997] sec. 4).
#include <fmt/format.h>

#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/key_table.hpp"
#include "core/component_graph/shapes/lattice_deformation.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::components {

namespace {

enum Key : std::size_t {
  low_x,
  low_y,
  low_z,
  size_x,
  size_y,
  size_z,
  points_x,
  points_y,
  points_z,
  moves,
  bends
};

constexpr NumberRange point_counts{.low = 2.0, .high = 10.0, .whole = true};
/// In the order of Bends.
constexpr std::array<std::string_view, 3> bends_words{"all", "all_but_leaves", "leaves"};

constexpr std::array<ComponentKey, 11> keys{{
    {"low_x", "length", "lower corner of the box of control points, in the component's directions",
     own_choice, "-0.5", RangedNumber{signed_lengths, -0.5}},
    {"low_y", "length", "the same along y", own_choice, "0.0", RangedNumber{signed_lengths, 0.0}},
    {"low_z", "length", "the same along z", own_choice, "-0.5", RangedNumber{signed_lengths, -0.5}},
    {"size_x", "length", "of the box; what is outside goes on as the box at its edge", own_choice,
     "1.0", RangedNumber{positive_lengths, 1.0}},
    {"size_y", "length", "the same along y", own_choice, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"size_z", "length", "the same along z", own_choice, "1.0",
     RangedNumber{positive_lengths, 1.0}},
    {"points_x", "1", "control points along x", own_choice, "2", RangedNumber{point_counts, 2.0}},
    {"points_y", "1", "control points along y", own_choice, "2", RangedNumber{point_counts, 2.0}},
    {"points_z", "1", "control points along z", own_choice, "2", RangedNumber{point_counts, 2.0}},
    {"moves", "length",
     "how far each control point is moved, three numbers each; x goes fastest, then y, then z; "
     "none: nothing is deformed",
     own_choice, "[]", NumberList{signed_lengths, {}, 0, 3000}},
    {"bends", "-", "what is bent; what is not keeps its shape and goes along", in_section_4,
     "\"all\"", WordChoice{bends_words, 0}},
}};

std::vector<Vector3> moves_of(const ComponentValues& values, const Lattice& lattice) {
  const auto [nx, ny, nz] = lattice.points;
  const std::size_t wanted = 3 * nx * ny * nz;
  const std::span<const double> numbers = values.list(moves);
  if (!numbers.empty() && numbers.size() != wanted)
    throw InputError(
        fmt::format("{} holds {} numbers, but {} x {} x {} control points need {}; give three for "
                    "each point, or none",
                    values.place_of_list(moves), numbers.size(), nx, ny, nz, wanted));
  std::vector<Vector3> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    vectors.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return vectors;
}

void change_context(const ComponentInput& input, BuildContext& context) {
  const ComponentValues& values = input.values;
  Lattice lattice;
  lattice.low = {values.number(low_x), values.number(low_y), values.number(low_z)};
  lattice.high =
      lattice.low + Vector3{values.number(size_x), values.number(size_y), values.number(size_z)};
  const Vector3 extent = lattice.high - lattice.low;
  if (!(extent.x > 0.0 && extent.y > 0.0 && extent.z > 0.0))
    throw InputError(
        "the box of a component of kind ffd is thinner than its place can tell; raise size_x, "
        "size_y and size_z, or move low_x, low_y and low_z nearer to 0");
  lattice.points = {values.count(points_x), values.count(points_y), values.count(points_z)};
  lattice.moves = moves_of(values, lattice);
  if (lattice.moves.empty()) return;
  context.deformations.push_back(std::make_shared<const LatticeDeformation>(
      input.frame, std::move(lattice), static_cast<Bends>(values.choice(bends))));
}

void place_children(const ComponentInput&, LinkKind, std::span<Frame> frames) {
  for (Frame& frame : frames) frame = Frame{};
}

}  // namespace

extern const ComponentKind ffd{
    .name = "ffd",
    .summary = "Bends all that follows, or only some of it, by a box of control points.",
    .source = "[Lintermann1997] sec. 4",
    .keys = keys,
    .place_children = place_children,
    .change_context = change_context,
};

}  // namespace phytobench::components
