// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_radii.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/lsystem/drawing_measures.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

constexpr double suitable_radius = 0.02;  // of the thickest branch, share of the plant's extent
constexpr double thickest_radius = 0.06;  // the same; more where widths are given
constexpr double share_of_segment = 0.2;  // no tip is chosen thicker than this share of a segment
constexpr double thinnest_share = 1e-3;   // of the thickest radius

double longest_side(const BoundingBox& box) {
  const Vector3 sides = box.extent();
  return std::max({sides.x, sides.y, sides.z});
}

/// What a unit of width adds to the radius.
double radius_of_width(float widest, WidthSource source, const PlantSize& size,
                       const DrawingPlantOptions& options) {
  if (options.length_of_width > 0.0) return 0.5 * options.length_of_width;
  const double radius = 0.5 * static_cast<double>(widest);
  const bool is_thick = radius > thickest_radius * size.extent && radius > 0.0;
  if (source == WidthSource::given || !is_thick) return 0.5;
  return 0.5 * suitable_radius * or_one(size.extent) / radius;
}

std::vector<double> radii_by_widths(const TurtleTree& tree, const PlantSize& size,
                                    const DrawingPlantOptions& options) {
  const float widest = *std::max_element(tree.widths.begin(), tree.widths.end());
  const double factor = radius_of_width(widest, tree.width_source, size, options);
  const double thinnest = widest > 0.0f ? thinnest_share * factor * static_cast<double>(widest)
                                        : thinnest_share * or_one(size.extent);
  std::vector<double> radii;
  radii.reserve(tree.widths.size());
  for (const float width : tree.widths)
    radii.push_back(std::max(factor * static_cast<double>(width), thinnest));
  return radii;
}

/// Such that the root is in proportion to the plant, and tips to their segments.
double suitable_tip_radius(double tips, const PlantSize& size, double exponent) {
  const double by_root = suitable_radius * size.extent / std::pow(tips, 1.0 / exponent);
  return or_one(std::min(by_root, share_of_segment * size.mean_length));
}

bool are_equal(const std::vector<float>& widths) {
  return std::adjacent_find(widths.begin(), widths.end(), std::not_equal_to<>()) == widths.end();
}

BranchRadii decided(BranchRadii radii, WidthSource source, const std::vector<float>& widths) {
  if (radii != BranchRadii::automatic) return radii;
  const bool is_said = source != WidthSource::nowhere || !are_equal(widths);
  return is_said ? BranchRadii::widths : BranchRadii::pipe_model;
}

}  // namespace

PlantSize plant_size(const Skeleton& skeleton) {
  BoundingBox box;
  double sum = 0.0;
  for (const Vector3& p : skeleton.positions()) box.extend(p);
  for (std::size_t node = 1; node < skeleton.node_count(); ++node)
    sum += norm(skeleton.positions()[node] - skeleton.position(skeleton.parents()[node]));
  return {longest_side(box),
          sum / static_cast<double>(std::max<std::size_t>(skeleton.edge_count(), 1))};
}

PlantSize plant_size(const Drawing& drawing) {
  const auto count = static_cast<double>(std::max<std::size_t>(drawing.segments.size(), 1));
  return {longest_side(segment_box(drawing)), total_length(drawing) / count};
}

std::vector<double> radii_of(const TurtleTree& tree, const PlantSize& size,
                             const DrawingPlantOptions& options) {
  if (decided(options.radii, tree.width_source, tree.widths) == BranchRadii::widths)
    return radii_by_widths(tree, size, options);
  const double tip =
      options.tip_radius > 0.0
          ? options.tip_radius
          : suitable_tip_radius(tips_above(tree.skeleton).front(), size, options.radius_exponent);
  return branch_radii(tree.skeleton, tip, options.radius_exponent);
}

DrawingPlantOptions options_for_all_lines(const Drawing& drawing, const PlantSize& size,
                                          const DrawingPlantOptions& options) {
  std::vector<float> widths;
  for (const TurtleSegment& segment : drawing.segments) widths.push_back(segment.width);
  DrawingPlantOptions same = options;
  same.radii = decided(options.radii, drawing.width_source, widths);
  if (!widths.empty() && same.radii == BranchRadii::widths)
    same.length_of_width = 2.0 * radius_of_width(*std::max_element(widths.begin(), widths.end()),
                                                 drawing.width_source, size, options);
  if (!(same.tip_radius > 0.0)) same.tip_radius = suitable_tip_radius(1.0, size, 1.0);
  return same;
}

std::vector<double> drawing_radii(const TurtleTree& tree, const DrawingPlantOptions& options) {
  return radii_of(tree, plant_size(tree.skeleton), options);
}

}  // namespace phytobench
