// SPDX-License-Identifier: MIT
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

/// A tree in a world, moved and turned within it.
TriangleMesh tree_in(const std::string& world, const std::string& tree) {
  const ComponentGraph graph = parse_component_graph(
      fmt::format("[graph]\nroot = \"w\"\n[component.w]\nkind = \"world\"\n{}\n"
                  "[component.s]\nkind = \"simple\"\nshape = \"none\"\nmove_x = 2.0\nturn_z = 40\n"
                  "[component.t]\nkind = \"tree\"\nsegments = 300\nradius_first = 1e-6\n"
                  "radius_last = 1e-6\n{}\n"
                  "[[link]]\nfrom = \"w\"\nto = \"s\"\n[[link]]\nfrom = \"s\"\nto = \"t\"\n",
                  world, tree),
      "world.toml");
  return build_plant(graph).parts.at(0).mesh;
}

/// Where the tree ends.
Vector3 tip_of(const TriangleMesh& mesh) {
  return mesh.positions.back();
}

TEST(WorldLaw, ConstantUpAndDownAreWhatThereIsWithoutIt) {
  Tried world("world");
  const BuildContext changed = world.changed_context();
  for (const Vector3& place : {Vector3{}, Vector3{3.0, -2.0, 8.0}}) {
    EXPECT_EQ(changed.photo->at(place, 1.0), (Vector3{0.0, 1.0, 0.0}));
    EXPECT_EQ(changed.gravi->at(place, 1.0), (Vector3{0.0, -1.0, 0.0}));
  }
  const std::string tropisms = "phototropism = 70\ngravitropism = 30";
  EXPECT_EQ(tree_in("photo = [\"0\", \"2\", \"0\"]", tropisms).positions,
            tree_in("", tropisms).positions);
}

TEST(World, LightMayComeFromAPoint) {
  const Vector3 tip = tip_of(tree_in("photo = [\"1 - x\", \"0.5 - y\", \"1.5 - z\"]",
                                     "phototropism = 9000\nlength = 1.0"));
  // Turned to it at once, the tree grows straight to the point.
  const Vector3 start{2.0, 0.0, 0.0}, way = Vector3{1.0, 0.5, 1.5} - start;
  EXPECT_LT(norm(tip - (start + way / norm(way))), 0.02);
}

TEST(World, WeightMayPullAwayFromAnAxis) {
  const Vector3 tip =
      tip_of(tree_in("gravi = [\"x\", \"0\", \"z\"]", "gravitropism = 9000\nlength = 5.0"));
  // It turns around within a few hundredths of its length first.
  EXPECT_LT(norm(tip - Vector3{7.0, 0.0, 0.0}), 0.2);
}

TEST(World, AFieldOfZeroPullsNowhere) {
  const std::string nowhere = "photo = [\"0\", \"0\", \"0\"]";
  EXPECT_EQ(tree_in(nowhere, "phototropism = 900").positions, tree_in("", "").positions);
}

}  // namespace
}  // namespace phytobench
