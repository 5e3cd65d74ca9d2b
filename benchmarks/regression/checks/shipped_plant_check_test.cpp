// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/shipped_plant_check.hpp"

#include <functional>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "benchmarks/regression/checks/umbrella_check.hpp"
#include "core/component_graph/component_graph_file.hpp"

namespace phytobench {
namespace {

TEST(ShippedPlantCheck, AcceptsAPlantAndSeesOneWrongNumber) {
  const ComponentGraph graph = parse_component_graph(UmbrellaPlant{}.graph(), "umbrellas");
  const BuiltPlant plant = build_plant(graph);
  EXPECT_EQ(objection_to_shipped_plant(graph, plant), "");
  EXPECT_NE(objection_to_shipped_plant(graph, {}), "");
  const std::function<void(BuiltPlant&)> changes[] = {
      [](BuiltPlant& wrong) { ++wrong.instances[2]; },
      [](BuiltPlant& wrong) { ++wrong.triangle_count; },
      [](BuiltPlant& wrong) { wrong.parts[1].mesh.triangles.clear(); },
      [](BuiltPlant& wrong) { wrong.parts[1].mesh.normals.pop_back(); },
      [](BuiltPlant& wrong) {
        wrong.parts[0].mesh.positions[3].y = std::numeric_limits<double>::quiet_NaN();
      },
      [](BuiltPlant& wrong) { wrong.parts[0].mesh.normals[3].y += 0.01; },
      [](BuiltPlant& wrong) { wrong.parts[0].mesh.triangles[9][1] = 1'000'000; },
      [](BuiltPlant& wrong) {
        std::swap(wrong.parts[0].mesh.triangles[9][1], wrong.parts[0].mesh.triangles[9][2]);
      },
  };
  for (const auto& change : changes) {
    BuiltPlant wrong = plant;
    change(wrong);
    EXPECT_NE(objection_to_shipped_plant(graph, wrong), "");
  }
}

}  // namespace
}  // namespace phytobench
