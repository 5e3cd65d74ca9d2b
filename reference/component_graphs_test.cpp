// SPDX-License-Identifier: MIT
// The plants of [Lintermann1997] sec. 5 as graphs of components.
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/geometry/bounding_box.hpp"
#include "reference/preset_files.hpp"

namespace phytobench {
namespace {

ComponentGraph shipped(const std::string& name) {
  const std::string names[] = {name};
  return read_component_graph(preset_file_named("graphs", names));
}

std::map<std::string, std::uint64_t> counts_of(const ComponentGraph& graph) {
  const auto per_prototype = instances_per_prototype(graph, make_instance_tree(graph));
  std::map<std::string, std::uint64_t> counts;
  for (std::size_t i = 0; i < per_prototype.size(); ++i)
    counts[graph.prototypes[i].name] = per_prototype[i];
  return counts;
}

/// The corners of the box around a plant.
BoundingBox box_of(const BuiltPlant& plant) {
  BoundingBox box;
  for (const MeshPart& part : plant.parts)
    for (const Vector3& place : part.mesh.positions) box.extend(place);
  return box;
}

TEST(ComponentGraphs, SayWhatTheyAreAndCanBeBuilt) {
  const auto graphs = preset_files("graphs");
  EXPECT_GE(graphs.size(), 3u);
  for (const PresetFile& preset : graphs) {
    EXPECT_GT(preset.summary.size(), 20u) << preset.name;
    EXPECT_LT(preset.summary.size(), 160u) << preset.name;
    const BuiltPlant plant = build_plant(read_component_graph(preset.file));
    EXPECT_GT(plant.triangle_count, 1000u) << preset.name;
    EXPECT_LT(plant.triangle_count, 2'000'000u) << preset.name;
  }
}

/// Without the leaves and what is ours: a stem, a ball, and 20 instances for each umbrella.
TEST(ComponentGraphs, TheDandelionHas300UmbrellasOf18Hairs) {
  const auto counts = counts_of(shipped("dandelion"));
  EXPECT_EQ(counts.at("ball"), 1u);
  EXPECT_EQ(counts.at("umbrella"), 300u);
  EXPECT_EQ(counts.at("hair"), 5400u);
  EXPECT_EQ(counts.at("stem") + counts.at("ball") + counts.at("stalk") + counts.at("umbrella") +
                counts.at("hair"),
            2u + 20u * 300u);
  const BoundingBox box = box_of(build_plant(shipped("dandelion")));
  EXPECT_GT(box.high().y, 0.1);
  EXPECT_LT(box.high().y, 0.5);
}

TEST(ComponentGraphs, TheBushHas363TwigsOn121Forks) {
  const auto counts = counts_of(shipped("bush"));
  EXPECT_EQ(counts.at("fork"), 121u);
  EXPECT_EQ(counts.at("twig"), 363u);
}

TEST(ComponentGraphs, TheWillowHangsAndItsTwigsStayOverTheGround) {
  const BuiltPlant plant = build_plant(shipped("weeping-willow"));
  const BoundingBox box = box_of(plant);
  EXPECT_GT(box.high().y, 6.0);
  EXPECT_LT(box.high().y, 14.0);
  constexpr double roots = -0.05;  // the lowest ring of a leaning trunk
  EXPECT_GT(box.low().y, roots);
}

}  // namespace
}  // namespace phytobench
