// SPDX-License-Identifier: MIT
// Whether a crown follows what its cloud is made of: a sphere that is pulled in three directions
// and cut at both ends. Every cloud is grown full.
#include <algorithm>
#include <cmath>

#include "core/geometry/bounding_box.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Shape {
  double width = 0.0, height = 0.0, depth = 0.0;
  double top_width = 0.0;     ///< mean distance from the axis in the upper third
  double bottom_width = 0.0;  ///< the same in the lower third
};

/// Mean horizontal distance from the crown root's vertical of the nodes between two heights.
double mean_distance_from_axis(std::span<const Vector3> crown, double low, double high) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Vector3& p : crown) {
    if (p.y < low || p.y > high) continue;
    sum += std::hypot(p.x - crown[0].x, p.z - crown[0].z);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

Shape shape_of(std::span<const Vector3> crown) {
  BoundingBox box;
  for (const Vector3& p : crown) box.extend(p);
  const Vector3 extent = box.extent();
  const double third = extent.y / 3.0;
  return {.width = extent.x,
          .height = extent.y,
          .depth = extent.z,
          .top_width = mean_distance_from_axis(crown, box.high().y - third, box.high().y),
          .bottom_width = mean_distance_from_axis(crown, box.low().y, box.low().y + third)};
}

/// One measure of the crowns of all trees in a cloud.
using Measure = double (*)(const Shape&);

ByTree record_measure(ExperimentContext& context, const std::string& name,
                      const CutEllipsoid& cloud, Measure measure) {
  TreeParameters parameters;
  parameters.cloud = cloud;
  parameters.cloud_density = 20.0;
  parameters.influence_distance = 1.0;
  parameters.kill_distance.begin = parameters.kill_distance.end = 0.4;
  parameters.iterations = 100;
  return record_trees(context, name, "1", [&](std::size_t number) {
    const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
    const Skeleton tree = grow_seedling(seedling, context).skeleton;
    const std::span<const Vector3> nodes(tree.positions().data(), tree.node_count());
    return measure(shape_of(nodes.subspan(static_cast<std::size_t>(seedling.crown_root))));
  });
}

constexpr CutEllipsoid sphere{.radii = {2.5, 2.5, 2.5}, .cutoff_bottom = 0.1, .cutoff_top = 0.1};

/// A change of the sphere, and what of the crown must grow with it.
struct Control {
  const char* name;
  CutEllipsoid cloud;
  Measure measure;
};

constexpr Control controls[] = {
    {"wider", {{4.0, 2.5, 2.5}, 0.1, 0.1}, [](const Shape& s) { return s.width / s.height; }},
    {"taller", {{2.5, 4.0, 2.5}, 0.1, 0.1}, [](const Shape& s) { return s.height / s.width; }},
    {"deeper", {{2.5, 2.5, 4.0}, 0.1, 0.1}, [](const Shape& s) { return s.depth / s.height; }},
    {"cut-at-the-top",
     {{2.5, 2.5, 2.5}, 0.1, 0.5},
     [](const Shape& s) { return s.top_width / s.bottom_width; }},
    {"cut-at-the-bottom",
     {{2.5, 2.5, 2.5}, 0.5, 0.1},
     [](const Shape& s) { return s.bottom_width / s.top_width; }},
};

void run(ExperimentContext& context) {
  for (const Control& control : controls) {
    const std::string name = control.name;
    const ByTree changed =
        record_measure(context, name + "/changed", control.cloud, control.measure);
    const ByTree plain = record_measure(context, name + "/sphere", sphere, control.measure);
    record_trend(context, name + "/changed-over-sphere", changed, plain);
  }
}

}  // namespace

extern const ExperimentDescriptor crown_shapes;
constinit const ExperimentDescriptor crown_shapes{
    .id = "brzoska2019/crown-shapes",
    .question = "Does a crown follow each change of the sphere that its cloud is made of?",
    .source = "[Brzoska2019] sec. 4.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
