// SPDX-License-Identifier: MIT
// Sec. 3.2: the example's twelve instances make the geometry, each in a coordinate system of its
// own.
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/plant_scene.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/picture/camera.hpp"
#include "core/picture/render.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/published_graphs.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr std::size_t horns = 10;  // B, then nine D: the only components with geometry

BuiltPlant example(const std::string& of_C) {
  return build_plant(published_example(3, loop_of_D, of_C));
}

std::int64_t triangles_of(const std::string& kind, const std::string& more = "") {
  return static_cast<std::int64_t>(
      build_plant(
          parse_component_graph(
              fmt::format("[graph]\nroot = \"a\"\n[component.a]\nkind = \"{}\"\n{}", kind, more),
              "one component"))
          .triangle_count);
}

/// Horns are equal and come in the order of the instances, so that each has as many vertices.
std::vector<BoundingBox> boxes_of_horns(const BuiltPlant& plant) {
  const TriangleMesh& mesh = plant.parts.at(0).mesh;
  const std::size_t each = mesh.vertex_count() / horns;
  std::vector<BoundingBox> boxes(horns);
  for (std::size_t i = 0; i < each * horns; ++i) boxes[i / each].extend(mesh.positions[i]);
  return boxes;
}

std::int64_t distinct_places_of_D(const BuiltPlant& plant) {
  std::vector<Vector3> places;
  const std::vector<BoundingBox> boxes = boxes_of_horns(plant);
  for (std::size_t i = 1; i < horns; ++i)
    places.push_back(0.5 * (boxes[i].low() + boxes[i].high()));
  return static_cast<std::int64_t>(distinct_point_count(places, 1e-9));
}

/// Which instance is not in the order of depth-first search: its parent must lie on the way to the
/// one before it.
std::int64_t out_of_order(const InstanceTree& tree) {
  std::int64_t count = 0;
  for (std::size_t i = 1; i < tree.instances.size(); ++i) {
    std::uint32_t at = static_cast<std::uint32_t>(i - 1);
    while (at != tree.instances[i].parent && at != 0) at = tree.instances[at].parent;
    count += at != tree.instances[i].parent;
  }
  return count;
}

void draw_picture(ExperimentContext& context, BuiltPlant plant) {
  if (context.tier() == Tier::smoke || !can_render()) return;
  const std::vector<SceneObject> objects = scene_objects(std::move(plant));
  Camera camera;
  camera.elevation_deg = 25.0;
  camera = fitted(camera, box_of(objects), 0.8);
  RenderOptions picture;
  picture.width = 360;
  picture.height = 450;
  picture.samples = 2;
  picture.threads = context.untimed_threads();
  context.artifact("figure-2c.jpg", to_jpeg(render(objects, camera, picture)));
}

void run(ExperimentContext& context) {
  const BuiltPlant plant = example("");
  context.record("instances", static_cast<std::int64_t>(plant.instance_count));
  context.record("triangles", static_cast<std::int64_t>(plant.triangle_count));
  context.record("triangles_of_a_horn", triangles_of("horn"));
  context.record("triangles_of_a_multiplier", triangles_of("hydra"));
  context.record("instances_out_of_order",
                 out_of_order(make_instance_tree(published_example(3, loop_of_D))));
  context.record("places_of_D", distinct_places_of_D(plant));
  context.record("same_frame_for_all/places_of_D", distinct_places_of_D(example("sweep = 0.0\n")));

  const std::vector<BoundingBox> boxes =
      boxes_of_horns(example("sweep = 0.0\ntilt = 0.0\nscale = [1.0, 0.5]\n"));
  for (std::size_t i = 1; i <= 3; ++i)
    context.record(fmt::format("scale-1-0.5/height_of_D_{}", i),
                   boxes[3 * i - 2].extent().y / boxes[1].extent().y);
  draw_picture(context, example("tilt = 50.0\nscale = [0.9, 0.6]\n"));
}

}  // namespace

extern const ExperimentDescriptor geometry_from_instances;
constinit const ExperimentDescriptor geometry_from_instances{
    .id = "lintermann1997/geometry-from-instances",
    .question = "How do nine instances of one prototype come to look different?",
    .source = "[Lintermann1997] sec. 3.2, fig. 2c",
    .seconds = {0.1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
