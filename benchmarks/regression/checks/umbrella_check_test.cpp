// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/umbrella_check.hpp"

#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include "core/component_graph/component_graph_file.hpp"

namespace phytobench {
namespace {

BuiltPlant built(const UmbrellaPlant& plant) {
  return build_plant(parse_component_graph(plant.graph(), "umbrellas"));
}

TEST(UmbrellaCheck, AcceptsWhatIsRight) {
  UmbrellaPlant plant;
  EXPECT_EQ(objection_to_umbrellas(built(plant), plant), "");
  plant.umbrellas = 7;
  plant.hairs = 5;
  plant.tilt_deg = 110.0;
  EXPECT_EQ(objection_to_umbrellas(built(plant), plant), "");
}

TEST(UmbrellaCheck, SeesAnotherPlant) {
  const UmbrellaPlant plant;
  const std::function<void(UmbrellaPlant&)> changes[] = {
      [](UmbrellaPlant& other) { other.umbrellas = 149; },
      [](UmbrellaPlant& other) { other.ball_radius = 2.0001; },
      [](UmbrellaPlant& other) { other.hairs = 17; },
      [](UmbrellaPlant& other) { other.tilt_deg = 65.001; },
      [](UmbrellaPlant& other) { other.stalk.length = 1.50001; },
      [](UmbrellaPlant& other) { other.stalk.radius_last = 0.021; },
      [](UmbrellaPlant& other) { other.hair.corners = 4; },
      [](UmbrellaPlant& other) { other.hair.radius_first = 0.0121; },
  };
  for (const auto& change : changes) {
    UmbrellaPlant other = plant;
    change(other);
    EXPECT_NE(objection_to_umbrellas(built(other), plant), "");
  }
  EXPECT_NE(objection_to_umbrellas({}, plant), "");
}

TEST(UmbrellaCheck, SeesOneWrongVertexTriangleAndNormal) {
  const UmbrellaPlant plant;
  const std::function<void(TriangleMesh&)> changes[] = {
      [](TriangleMesh& mesh) { mesh.positions[777].x += 1e-9; },
      [](TriangleMesh& mesh) { std::swap(mesh.positions[12], mesh.positions[13]); },
      [](TriangleMesh& mesh) { mesh.normals[500] = -1.0 * mesh.normals[500]; },
      [](TriangleMesh& mesh) { std::swap(mesh.triangles[40][0], mesh.triangles[40][1]); },
      [](TriangleMesh& mesh) { mesh.triangles[40] = mesh.triangles[41]; },
      [](TriangleMesh& mesh) { mesh.triangles.pop_back(); },
  };
  for (const std::size_t part : {0u, 1u})
    for (const auto& change : changes) {
      BuiltPlant wrong = built(plant);
      change(wrong.parts[part].mesh);
      EXPECT_NE(objection_to_umbrellas(wrong, plant), "") << part;
    }
}

}  // namespace
}  // namespace phytobench
