// SPDX-License-Identifier: MIT
#include "cli/build_findings.hpp"

#include <utility>

#include "core/component_graph/instance_measures.hpp"
#include "core/component_graph/plant_scene.hpp"
#include "core/contract/check.hpp"

namespace phytobench::cli {

std::size_t BuildFindings::triangle_count() const {
  std::size_t count = 0;
  for (const MaterialFindings& material : materials) count += material.triangles;
  return count;
}

std::size_t BuildFindings::vertex_count() const {
  std::size_t count = 0;
  for (const MaterialFindings& material : materials) count += material.vertices;
  return count;
}

BuildFindings counted_instances(const ComponentGraph& graph) {
  const InstanceTree tree = make_instance_tree(graph);
  BuildFindings findings;
  findings.time = graph.time;
  findings.instances = instances_per_prototype(graph, tree);
  findings.link_instances = instances_per_link(graph, tree);
  findings.instance_count = tree.instances.size();
  findings.levels = level_count(tree);
  findings.predicted = predicted_counts(graph);
  const std::string problem = count_disagreement(graph, findings.instances, findings.predicted);
  if (!problem.empty())
    throw ContractViolation(problem + " (a bug in phytobench, please report it with the graph)");
  return findings;
}

std::vector<SceneObject> add_plant(BuildFindings& findings, BuiltPlant plant) {
  for (const MeshPart& part : plant.parts)
    findings.materials.push_back({.material = part.material});
  std::vector<SceneObject> objects = scene_objects(std::move(plant));
  PHYTOBENCH_ENSURE(objects.size() == findings.materials.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    MaterialFindings& material = findings.materials[i];
    material.name = objects[i].name;
    material.triangles = objects[i].mesh.triangle_count();
    material.vertices = objects[i].mesh.vertex_count();
  }
  findings.box = box_of(objects);
  return objects;
}

}  // namespace phytobench::cli
