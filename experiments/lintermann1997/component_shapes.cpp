// SPDX-License-Identifier: MIT
// Sec. 4 and figure 3: volumes and surfaces of the bodies of a simple component, and of a horn that
// is made of point sets joined by triangles.
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/tree/mesh_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

void record_topology(ExperimentContext& context, const std::string& name,
                     const TriangleMesh& mesh) {
  const SurfaceEdges edges(mesh);
  context.record(name + "open_edges", whole(edges.open_edges()));
  context.record(name + "euler_characteristic", edges.euler_characteristic());
}

void record_bodies(ExperimentContext& context) {
  const auto body = [](const char* shape, int corners) {
    return SingleComponent("simple", fmt::format("shape = \"{}\"\ncorners = {}\nsize_x = 2\n"
                                                 "size_y = 3\nsize_z = 5",
                                                 shape, corners))
        .mesh();
  };
  const double box_of_sizes = 2.0 * 3.0 * 5.0, pi = std::numbers::pi;
  const std::pair<const char*, double> shapes[] = {
      {"box", 1.0}, {"cylinder", pi / 4.0}, {"sphere", pi / 6.0}};
  for (const auto& [shape, share] : shapes) {
    const std::string name = fmt::format("{}/", shape);
    for (const int corners : {16, 64, 256}) {
      if (corners > 16 && share == 1.0) break;  // a box has no corners to set
      context.record(fmt::format("{}corners-{}/volume_ratio", name, corners),
                     enclosed_volume(body(shape, corners)) / (share * box_of_sizes));
    }
    record_topology(context, name, body(shape, 16));
  }
}

TriangleMesh horn(const char* keys) {
  return SingleComponent("horn", fmt::format("length = 2\nsegments = 6\ncorners = 7\n{}", keys))
      .mesh();
}

/// A frustum over a regular polygon of 7 corners.
void record_cone(ExperimentContext& context) {
  const double polygon = 3.5 * std::sin(2.0 * std::numbers::pi / 7.0);  // of a circle of radius 1
  const double frustum = polygon * 2.0 / 3.0 * (0.09 + 0.03 + 0.01);
  const TriangleMesh straight = horn("radius_first = 0.3\nradius_last = 0.1");
  context.record("horn/volume_ratio_to_frustum", enclosed_volume(straight) / frustum);
  const TriangleMesh pointed = horn("radius_first = 0.3\nradius_last = 0");
  context.record("horn/volume_ratio_to_cone",
                 enclosed_volume(pointed) / (polygon * 2.0 / 3.0 * 0.09));
  record_topology(context, "horn/", horn("bend_first = 20\nbend_last = -9"));
  const TriangleMesh tube = horn("radius_first = 0.3\nradius_last = 0.1\ncaps = \"none\"");
  context.record("horn/without_ends/triangles", static_cast<std::int64_t>(tube.triangle_count()));
  context.record("horn/without_ends/open_edges", whole(SurfaceEdges(tube).open_edges()));
  const TriangleMesh cone = horn("radius_first = 0.3\nradius_last = 0\ncaps = \"none\"");
  context.record("horn/pointed/triangles", static_cast<std::int64_t>(cone.triangle_count()));
}

/// Equal turns at all joints and one radius: every point set is the one before under one and the
/// same map, so that each point moves by the same distance each time. At both ends sets stand
/// across their piece and not halfway between two.
void record_point_sets(ExperimentContext& context) {
  const TriangleMesh mesh = horn(
      "radius_first = 0.2\nradius_last = 0.2\nbend_first = 14\nbend_last = 14\ntwist = 11\n"
      "caps = \"none\"");
  constexpr std::size_t sets = 7, points = 8;  // the first point of a set once more for the seam
  context.record("horn/point_sets", static_cast<std::int64_t>(mesh.vertex_count() / points));
  double deviation = 0.0;
  for (std::size_t set = 2; set + 2 < sets; ++set)
    for (std::size_t i = 0; i < points; ++i) {
      const auto moved = [&](std::size_t from) {
        return norm(mesh.positions[(from + 1) * points + i] - mesh.positions[from * points + i]);
      };
      deviation = std::fmax(deviation, std::abs(moved(set) - moved(1)));
    }
  context.record("horn/deviation_from_one_relative_map", deviation, "length");
}

void run(ExperimentContext& context) {
  record_bodies(context);
  record_cone(context);
  record_point_sets(context);
}

}  // namespace

extern const ExperimentDescriptor component_shapes;
constinit const ExperimentDescriptor component_shapes{
    .id = "lintermann1997/component-shapes",
    .question = "Which bodies do simple components and horns make, and are their surfaces closed?",
    .source = "[Lintermann1997] sec. 4, fig. 3",
    .seconds = {0.05, 0.05, 0.05},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
