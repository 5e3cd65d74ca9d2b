// SPDX-License-Identifier: MIT
// Sec. 5 and 6: the three plants that come with the suite: how much they make of how little, and
// whether their parameters leave their structure alone.
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"
#include "reference/component_counts.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

std::string hash_of(const InstanceTree& tree) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Instance& instance : tree.instances)
    for (const std::uint32_t part : {instance.prototype, instance.parent, instance.link}) {
      hash ^= part;
      hash *= 0x100000001b3;
    }
  return fmt::format("{:016x}", hash);
}

/// Every number that says how large, how bent or where, at its default again. Those are all but
/// whole numbers, with which structure and detail are set.
ComponentGraph without_geometry_settings(ComponentGraph graph) {
  for (Prototype& prototype : graph.prototypes)
    for (std::size_t i = 0; i < prototype.settings.size(); ++i) {
      const auto* number = std::get_if<RangedNumber>(&prototype.kind->keys[i].kind);
      if (number != nullptr && !number->range.whole)
        prototype.settings[i] = ParameterRange::of(number->default_value);
    }
  return graph;
}

void record_plant(ExperimentContext& context, const std::string& plant) {
  context.progress(plant);
  const ComponentGraph graph = read_component_graph(graph_preset_file(plant));
  const InstanceTree tree = make_instance_tree(graph);
  const std::string name = plant + "/";
  context.record(name + "prototypes", static_cast<std::int64_t>(graph.prototypes.size()));
  context.record(name + "links", static_cast<std::int64_t>(graph.links.size()));
  context.record(name + "instances", static_cast<std::int64_t>(tree.instances.size()));
  const auto made = instances_per_prototype(graph, tree);
  const std::string objection = count_disagreement(graph, made, predicted_counts(graph));
  context.record(name + "disagrees_with_grammar", std::int64_t{!objection.empty()});
  for (std::size_t i = 0; i < made.size(); ++i)
    context.record(name + "of/" + graph.prototypes[i].name, static_cast<std::int64_t>(made[i]));
  context.record(name + "structure", hash_of(tree));
  context.record(name + "structure_with_other_geometry",
                 hash_of(make_instance_tree(without_geometry_settings(graph))));
}

struct Built {
  std::int64_t triangles = 0;
  double height = 0.0;
};

Built built(const ComponentGraph& graph) {
  const BuiltPlant plant = build_plant(graph);
  Built result;
  result.triangles = static_cast<std::int64_t>(plant.triangle_count);
  for (const MeshPart& part : plant.parts)
    for (const Vector3& place : part.mesh.positions)
      result.height = std::fmax(result.height, place.y);
  return result;
}

std::int64_t triangles_of_one(const ComponentGraph& graph, std::uint32_t prototype) {
  ComponentGraph alone = graph;
  alone.root = prototype;
  alone.links.clear();
  return built(alone).triangles;
}

/// All instances of a prototype of these plants have meshes of one size: to multiply is faster than
/// to build.
void record_triangles(ExperimentContext& context, const std::string& plant) {
  const ComponentGraph graph = read_component_graph(graph_preset_file(plant));
  const auto made = instances_per_prototype(graph, make_instance_tree(graph));
  std::int64_t triangles = 0;
  for (std::uint32_t i = 0; i < graph.prototypes.size(); ++i) {
    const std::int64_t of_one = triangles_of_one(graph, i);
    triangles += of_one * static_cast<std::int64_t>(made[i]);
    if (plant == "dandelion" && of_one > 0)
      context.record("dandelion/triangles_of_one/" + graph.prototypes[i].name, of_one);
  }
  context.record(plant + "/triangles", triangles);
}

/// The smaller two, built with their numbers and with the defaults.
void record_other_geometry(ExperimentContext& context) {
  for (const char* plant : {"dandelion", "bush"}) {
    const ComponentGraph graph = read_component_graph(graph_preset_file(plant));
    const Built here = built(graph), other = built(without_geometry_settings(graph));
    context.record(fmt::format("{}/triangles_built", plant), here.triangles);
    context.record(fmt::format("{}/height", plant), here.height, "length");
    context.record(fmt::format("{}/height_with_other_geometry", plant), other.height, "length");
  }
}

/// The leaves of the rosette differ in size and angle, by parameters of the hydra alone.
void record_rosette(ExperimentContext& context) {
  const auto leaves =
      SingleComponent("hydra", "count = 11\ntilt = [76, 40]\nscale = [1.0, 0.5]").children(11);
  double largest = 0.0, smallest = 1e9;
  for (const Frame& leaf : leaves) {
    largest = std::fmax(largest, leaf.scale);
    smallest = std::fmin(smallest, leaf.scale);
  }
  context.record("rosette/largest_leaf", largest);
  context.record("rosette/smallest_leaf", smallest);
  context.record("rosette/first_angle", angle_deg(leaves.front().y, {0, 1, 0}), "degrees");
  context.record("rosette/last_angle", angle_deg(leaves.back().y, {0, 1, 0}), "degrees");
}

void run(ExperimentContext& context) {
  for (const char* plant : {"dandelion", "weeping-willow", "bush"}) {
    record_plant(context, plant);
    record_triangles(context, plant);
  }
  record_other_geometry(context);
  record_rosette(context);
}

}  // namespace

extern const ExperimentDescriptor example_plants;
constinit const ExperimentDescriptor example_plants{
    .id = "lintermann1997/example-plants",
    .question = "How much do the three plants make of how little, and what decides on it?",
    .source = "[Lintermann1997] sec. 5, 6",
    .seconds = {0.5, 0.5, 0.5},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
