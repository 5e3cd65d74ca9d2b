// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_plant.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_lines.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_radii.hpp"
#include "core/lsystem/outline_triangles.hpp"
#include "core/tree/branch_mesh.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_segments = 4'000'000;

void check_size(std::size_t segments) {
  if (segments > most_segments)
    throw InputError(fmt::format(
        "a drawing of {} segments is too large for a mesh (at most {}); derive fewer steps",
        segments, most_segments));
}

/// Appends the tubes of one tree; colours per node.
void add_tubes(const Skeleton& skeleton, const std::vector<double>& radii,
               const std::vector<std::uint16_t>& colours, double extent,
               const DrawingPlantOptions& options, DrawingPlant& plant) {
  BranchMeshOptions mesh_options;
  mesh_options.circle_resolution = options.circle_resolution;
  constexpr double texture_repeats = 8.0;
  mesh_options.texture_length = or_one(extent / texture_repeats);
  TriangleMesh tubes = mesh_branches(skeleton, radii, mesh_options).mesh;
  // Rings are in the order of the nodes, and every triangle's second corner is on the ring of the
  // node that its edge leads to.
  const auto ring_size = static_cast<std::uint32_t>(options.circle_resolution + 1);
  for (const Triangle& triangle : tubes.triangles)
    plant.branch_colours.push_back(colours[triangle[1] / ring_size]);
  if (plant.branches.positions.empty())
    plant.branches = std::move(tubes);
  else
    append(plant.branches, tubes);
}

/// One side of a polygon; the other one with its corners the other way round.
void add_side(const OutlineTriangles& filled, double side, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  const Vector3 along = cross(filled.normal, filled.across);
  BoundingBox box;
  for (const Vector3& corner : filled.corners)
    box.extend({dot(corner, filled.across), dot(corner, along), 0.0});
  for (const Vector3& corner : filled.corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(side * filled.normal);
    mesh.texture_points.push_back(
        {(dot(corner, filled.across) - box.low().x) / or_one(box.extent().x),
         (dot(corner, along) - box.low().y) / or_one(box.extent().y)});
  }
  for (const auto& [a, b, c] : filled.triangles)
    mesh.triangles.push_back(side > 0.0 ? Triangle{first + a, first + b, first + c}
                                        : Triangle{first + a, first + c, first + b});
}

void add_leaves(const Drawing& drawing, DrawingPlant& plant) {
  check_size(drawing.corners.size());
  for (const TurtlePolygon& polygon : drawing.polygons) {
    if (polygon.count > most_outline_corners)
      throw InputError(fmt::format("a polygon of {} corners is too large for a mesh (at most {})",
                                   polygon.count, most_outline_corners));
    const OutlineTriangles filled = outline_triangles(corners_of(drawing, polygon));
    if (filled.triangles.empty()) continue;
    add_side(filled, 1.0, plant.leaves);
    add_side(filled, -1.0, plant.leaves);
    plant.leaf_colours.insert(plant.leaf_colours.end(), 2 * filled.triangles.size(),
                              polygon.colour);
  }
}

/// A line as a tree without branches.
TurtleTree tree_of(const DrawnLine& line, const Drawing& drawing) {
  TurtleTree tree;
  tree.width_source = drawing.width_source;
  tree.skeleton = Skeleton(line.points.front());
  const TurtleSegment& first = drawing.segments[line.segments.front()];
  tree.widths.push_back(first.width);
  tree.colours.push_back(first.colour);
  for (std::size_t i = 0; i < line.segments.size(); ++i) {
    tree.skeleton.append(static_cast<std::int32_t>(i), line.points[i + 1]);
    tree.widths.push_back(drawing.segments[line.segments[i]].width);
    tree.colours.push_back(drawing.segments[line.segments[i]].colour);
  }
  return tree;
}

std::optional<TurtleTree> tree_if_connected(const LSystem& system, const Word& word) {
  try {
    return turtle_tree(system, word);
  } catch (const InputError&) {
    return std::nullopt;  // all other errors have come up in draw()
  }
}

}  // namespace

DrawingPlant make_drawing_plant(const TurtleTree& tree, const Drawing& drawing,
                                const DrawingPlantOptions& options) {
  check_size(tree.skeleton.edge_count());
  DrawingPlant plant;
  if (tree.skeleton.edge_count() > 0) {
    const std::vector<double> radii = drawing_radii(tree, options);
    plant.root_radius = radii.front();
    add_tubes(tree.skeleton, radii, tree.colours, plant_size(tree.skeleton).extent, options, plant);
  }
  add_leaves(drawing, plant);
  return plant;
}

DrawingPlant make_drawing_plant(const Drawing& drawing, const DrawingPlantOptions& options) {
  check_size(drawing.segments.size());
  const PlantSize size = plant_size(drawing);
  const DrawingPlantOptions same = options_for_all_lines(drawing, size, options);
  DrawingPlant plant;
  for (const DrawnLine& line : drawn_lines(drawing, [](const TurtleSegment&) { return 0u; })) {
    const TurtleTree tree = tree_of(line, drawing);
    const std::vector<double> radii = radii_of(tree, size, same);
    plant.root_radius = std::max(plant.root_radius, radii.front());
    add_tubes(tree.skeleton, radii, tree.colours, size.extent, same, plant);
  }
  add_leaves(drawing, plant);
  return plant;
}

DrawingPlant make_drawing_plant(const LSystem& system, const Word& word,
                                const DrawingPlantOptions& options) {
  const Drawing drawing = draw(system, word);
  check_size(drawing.segments.size());
  if (const auto tree = tree_if_connected(system, word))
    return make_drawing_plant(*tree, drawing, options);
  return make_drawing_plant(drawing, options);
}

}  // namespace phytobench
