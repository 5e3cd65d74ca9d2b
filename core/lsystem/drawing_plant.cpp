// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_plant.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_lines.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/outline_triangles.hpp"
#include "core/tree/branch_mesh.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_segments = 4'000'000;
constexpr double suitable_radius = 0.02;  // of the thickest branch, share of the plant's extent
constexpr double thickest_radius = 0.06;
constexpr double share_of_segment = 0.2;  // no tip is chosen thicker than this share of a segment
constexpr double thinnest_share = 1e-3;   // of the thickest radius

/// What radii are chosen by.
struct PlantSize {
  double extent = 0.0;       // longest side of the box
  double mean_length = 0.0;  // of the segments
};

PlantSize size_of(const Skeleton& skeleton) {
  BoundingBox box;
  double sum = 0.0;
  for (const Vector3& p : skeleton.positions()) box.extend(p);
  for (std::size_t node = 1; node < skeleton.node_count(); ++node)
    sum += norm(skeleton.positions()[node] - skeleton.position(skeleton.parents()[node]));
  const Vector3 sides = box.extent();
  return {std::max({sides.x, sides.y, sides.z}),
          sum / static_cast<double>(std::max<std::size_t>(skeleton.edge_count(), 1))};
}

/// For a drawing that is nothing but a point.
double or_one(double length) {
  return length > 0.0 ? length : 1.0;
}

double radius_of_width(float widest, const PlantSize& size, const DrawingPlantOptions& options) {
  if (options.length_of_width > 0.0) return 0.5 * options.length_of_width;
  const double radius = 0.5 * static_cast<double>(widest);
  if (radius <= thickest_radius * size.extent || !(radius > 0.0)) return 0.5;
  return 0.5 * suitable_radius * or_one(size.extent) / radius;
}

std::vector<double> radii_by_widths(const std::vector<float>& widths, const PlantSize& size,
                                    const DrawingPlantOptions& options) {
  const float widest = *std::max_element(widths.begin(), widths.end());
  const double factor = radius_of_width(widest, size, options);
  const double thinnest = widest > 0.0f ? thinnest_share * factor * static_cast<double>(widest)
                                        : thinnest_share * or_one(size.extent);
  std::vector<double> radii;
  radii.reserve(widths.size());
  for (const float width : widths)
    radii.push_back(std::max(factor * static_cast<double>(width), thinnest));
  return radii;
}

/// Such that the root is in proportion to the plant, and tips to their segments.
double suitable_tip_radius(const Skeleton& skeleton, const PlantSize& size, double exponent) {
  const double tips = tips_above(skeleton).front();
  const double by_root = suitable_radius * size.extent / std::pow(tips, 1.0 / exponent);
  return or_one(std::min(by_root, share_of_segment * size.mean_length));
}

bool are_equal(const std::vector<float>& widths) {
  return std::adjacent_find(widths.begin(), widths.end(), std::not_equal_to<>()) == widths.end();
}

std::vector<double> radii_of(const Skeleton& skeleton, const std::vector<float>& widths,
                             const PlantSize& size, const DrawingPlantOptions& options) {
  const bool by_widths = options.radii == BranchRadii::widths ||
                         (options.radii == BranchRadii::automatic && !are_equal(widths));
  if (by_widths) return radii_by_widths(widths, size, options);
  const double tip = options.tip_radius > 0.0
                         ? options.tip_radius
                         : suitable_tip_radius(skeleton, size, options.radius_exponent);
  return branch_radii(skeleton, tip, options.radius_exponent);
}

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

std::vector<double> drawing_radii(const TurtleTree& tree, const DrawingPlantOptions& options) {
  return radii_of(tree.skeleton, tree.widths, size_of(tree.skeleton), options);
}

DrawingPlant make_drawing_plant(const TurtleTree& tree, const Drawing& drawing,
                                const DrawingPlantOptions& options) {
  check_size(tree.skeleton.edge_count());
  DrawingPlant plant;
  if (tree.skeleton.edge_count() > 0) {
    const std::vector<double> radii = drawing_radii(tree, options);
    plant.root_radius = radii.front();
    add_tubes(tree.skeleton, radii, tree.colours, size_of(tree.skeleton).extent, options, plant);
  }
  add_leaves(drawing, plant);
  return plant;
}

DrawingPlant make_drawing_plant(const Drawing& drawing, const DrawingPlantOptions& options) {
  check_size(drawing.segments.size());
  const Vector3 sides = segment_box(drawing).extent();
  const auto count = static_cast<double>(std::max<std::size_t>(drawing.segments.size(), 1));
  const PlantSize size{std::max({sides.x, sides.y, sides.z}), total_length(drawing) / count};
  std::vector<float> widths;
  for (const TurtleSegment& segment : drawing.segments) widths.push_back(segment.width);
  DrawingPlantOptions same = options;  // for all lines
  if (same.radii == BranchRadii::automatic)
    same.radii = are_equal(widths) ? BranchRadii::pipe_model : BranchRadii::widths;
  if (!widths.empty() && same.radii == BranchRadii::widths)
    same.length_of_width =
        2.0 * radius_of_width(*std::max_element(widths.begin(), widths.end()), size, options);
  if (!(same.tip_radius > 0.0))
    same.tip_radius =
        or_one(std::min(suitable_radius * size.extent, share_of_segment * size.mean_length));
  DrawingPlant plant;
  for (const DrawnLine& line : drawn_lines(drawing, [](const TurtleSegment&) { return 0u; })) {
    const TurtleTree tree = tree_of(line, drawing);
    const std::vector<double> radii = radii_of(tree.skeleton, tree.widths, size, same);
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
