// SPDX-License-Identifier: MIT
// Figures 6 to 9 again, from the plants that come with the suite. The article fixes neither sizes
// nor colours, so that only the make-up of the plants can be compared.
#include <algorithm>

#include "core/component_graph/plant_scene.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/picture/render.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int width = 320, height = 400;
constexpr double coarse = 0.34;  // detail of smoke runs: the fewest corners and pieces

std::uint32_t position_of(const ComponentGraph& graph, std::string_view prototype) {
  std::uint32_t i = 0;
  while (graph.prototypes.at(i).name != prototype) ++i;
  return i;
}

/// The preset from that component on.
ComponentGraph below(const char* plant, const char* root) {
  ComponentGraph graph = read_component_graph(graph_preset_file(plant));
  graph.root = position_of(graph, root);
  return graph;
}

/// The preset without that component and what hangs below it.
ComponentGraph without(const char* plant, const char* component) {
  ComponentGraph graph = read_component_graph(graph_preset_file(plant));
  const std::uint32_t left_out = position_of(graph, component);
  std::erase_if(graph.links, [&](const ComponentLink& link) { return link.to == left_out; });
  return graph;
}

/// Two trees, the second on the first by a branch link, as they are before anything is set.
ComponentGraph two_trees() {
  return graph_of(
      "[graph]\nroot = \"a\"\n[component.a]\nkind = \"tree\"\n[component.b]\nkind = \"tree\"\n"
      "[[link]]\nfrom = \"a\"\nto = \"b\"\nkind = \"branch\"\n");
}

void draw(ExperimentContext& context, const std::string& figure, const ComponentGraph& graph) {
  context.progress("picture of " + figure);
  const bool smoke = context.tier() == Tier::smoke;
  BuildOptions build;
  build.resolution = smoke ? coarse : 1.0;
  BuiltPlant plant = build_plant(graph, build);
  BoundingBox box;
  for (const MeshPart& part : plant.parts)
    for (const Vector3& place : part.mesh.positions) box.extend(place);
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.samples = smoke ? 1 : context.tier() == Tier::quick ? 2 : 3;
  options.threads = context.untimed_threads();
  const std::vector<SceneObject> objects = scene_objects(std::move(plant));
  const Camera camera = fitted({}, box, static_cast<double>(width) / height);
  context.artifact(figure + ".jpg", to_jpeg(render(objects, camera, options)));
}

void run(ExperimentContext& context) {
  context.record("can_render", std::int64_t{can_render()});
  if (!can_render()) return;
  draw(context, "figure-6-a", below("dandelion", "hair"));
  draw(context, "figure-6-b", below("dandelion", "stalk"));
  draw(context, "figure-6-c", below("dandelion", "plant"));
  draw(context, "figure-7-a", two_trees());
  draw(context, "figure-7-b", without("weeping-willow", "twig"));
  draw(context, "figure-8", below("bush", "fork"));
  if (context.tier() != Tier::full) return;  // a million triangles
  draw(context, "figure-7-c", below("weeping-willow", "trunk"));
  draw(context, "figure-9-naked-willow", without("weeping-willow", "blade"));
}

}  // namespace

extern const ExperimentDescriptor example_pictures;
constinit const ExperimentDescriptor example_pictures{
    .id = "lintermann1997/example-pictures",
    .question = "What do dandelion, willow and bush look like at the steps of their making?",
    .source = "[Lintermann1997] fig. 6-9",
    .seconds = {1, 3, 18},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
