// SPDX-License-Identifier: MIT
// From a graph of components to a plant: unfolding, and triangles.
#include <fmt/format.h>

#include "benchmarks/regression/checks/shipped_plant_check.hpp"
#include "benchmarks/regression/checks/umbrella_check.hpp"
#include "benchmarks/regression/checks/unfolding_check.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/contract/text_file.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench::families {

namespace {

using Objection = std::function<std::string(const ComponentGraph&, const BuiltPlant&)>;

class BuildKernel final : public WatchedKernel {
 public:
  BuildKernel(const std::string& text, Objection objection)
      : text_(text),
        graph_(parse_component_graph(text, "graph")),
        objection_(std::move(objection)) {}

  std::string inputs() const override { return KernelDigest().add(text_).hex(); }

  void run() override { plant_ = build_plant(graph_); }

  std::string answer() const override {
    KernelDigest digest;
    for (const MeshPart& part : plant_.parts)
      digest.add(part.mesh.positions)
          .add(part.mesh.normals)
          .add(part.mesh.texture_points)
          .add(part.mesh.triangles);
    return digest.add(plant_.instances).hex();
  }

  WorkCounts work() const override {
    std::uint64_t vertices = 0;
    for (const MeshPart& part : plant_.parts) vertices += part.mesh.vertex_count();
    return {{"instances", plant_.instance_count},
            {"vertices", vertices},
            {"triangles", plant_.triangle_count}};
  }

  std::string objection() override { return objection_(graph_, plant_); }

 private:
  std::string text_;
  ComponentGraph graph_;
  Objection objection_;
  BuiltPlant plant_;
};

/// The i-tree alone.
class UnfoldingKernel final : public WatchedKernel {
 public:
  std::string inputs() const override { return KernelDigest().add(unfolding_text()).hex(); }
  void run() override { tree_ = make_instance_tree(graph_); }

  std::string answer() const override {
    std::vector<std::uint64_t> numbers;
    for (const Instance& instance : tree_.instances)
      for (const std::uint64_t number :
           {std::uint64_t{instance.prototype}, std::uint64_t{instance.parent},
            std::uint64_t{instance.link}, std::uint64_t{instance.number.i}, instance.identity})
        numbers.push_back(number);
    return KernelDigest().add(numbers).hex();
  }

  WorkCounts work() const override { return {{"instances", tree_.instances.size()}}; }
  std::string objection() override { return objection_to_unfolding(graph_, tree_); }

 private:
  ComponentGraph graph_ = parse_component_graph(unfolding_text(), "graph");
  InstanceTree tree_;
};

WatchedBenchmark umbrellas() {
  return {.name = "component-graph/umbrellas",
          .summary = "Builds umbrellas on a ball, as a dandelion has them.",
          .is_own = true,
          .prepare = [] {
            const UmbrellaPlant plant;
            return std::make_unique<BuildKernel>(
                plant.graph(), [plant](const ComponentGraph&, const BuiltPlant& built) {
                  return objection_to_umbrellas(built, plant);
                });
          }};
}

WatchedBenchmark shipped(const std::string& preset) {
  return {.name = "component-graph/" + preset,
          .summary = fmt::format("Builds the graph '{}' that comes with the program.", preset),
          .is_own = true,
          .prepare = [preset] {
            return std::make_unique<BuildKernel>(read_text_file(graph_preset_file(preset)),
                                                 objection_to_shipped_plant);
          }};
}

std::vector<WatchedBenchmark> list_plants(const FamilyRequest&) {
  std::vector<WatchedBenchmark> all{
      umbrellas(),
      {.name = "component-graph/unfolding",
       .summary = "Unfolds a recursion through a multiplier into some twenty thousand instances.",
       .is_own = true,
       .prepare = [] { return std::make_unique<UnfoldingKernel>(); }}};
  // By name: what is watched can be listed where the program's data are not. (The willow would take
  // as long as all others together, for the same kinds of components.)
  for (const char* preset : {"bush", "dandelion"}) all.push_back(shipped(preset));
  return all;
}

}  // namespace

extern const BenchmarkFamily component_graph;
constinit const BenchmarkFamily component_graph{
    .name = "component_graph",
    .summary = "Building plants from components.",
    .list = list_plants,
};

}  // namespace phytobench::families
