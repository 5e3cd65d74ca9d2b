// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/plant_check.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;

/// A stem with twigs, each of two edges.
Skeleton brush() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  for (int i = 0; i < 60; ++i) {
    tree.append(1, {std::cos(i), 1.5, std::sin(i)});
    tree.append(static_cast<std::int32_t>(tree.node_count()) - 1,
                {1.5 * std::cos(i), 1.7, 1.5 * std::sin(i)});
  }
  return tree;
}

class PlantCheckTest : public testing::Test {
 protected:
  Skeleton skeleton_ = brush();
  PlantParameters parameters_;
  Plant plant_ = make_plant(skeleton_, parameters_);

  std::string objection() const { return objection_to_plant(plant_, skeleton_, parameters_); }
};

TEST_F(PlantCheckTest, AcceptsWhatIsRight) {
  EXPECT_EQ(objection(), "");
  EXPECT_GT(plant_.branches.duplicated_rings, 0u);
  EXPECT_GT(plant_.leaves.size(), 0u);
}

TEST_F(PlantCheckTest, SeesARadiusThatDoesNotFollowTheRule) {
  plant_.radii[1] *= 1.001;
  EXPECT_THAT(objection(), HasSubstr("node 0: radius"));
}

TEST_F(PlantCheckTest, SeesATriangleTooFew) {
  plant_.branches.mesh.triangles.pop_back();
  EXPECT_THAT(objection(), HasSubstr("triangles of branches"));
  plant_ = make_plant(skeleton_, parameters_);
  plant_.leaf_mesh.triangles.pop_back();
  EXPECT_THAT(objection(), HasSubstr("triangles of leaves"));
}

TEST_F(PlantCheckTest, SeesAVertexTooMany) {
  plant_.branches.mesh.positions.push_back({0, 0, 0});
  EXPECT_THAT(objection(), HasSubstr("vertices of branches"));
}

TEST_F(PlantCheckTest, SeesAVertexOutOfPlace) {
  plant_.branches.mesh.positions[5].x += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("from node 1"));
}

TEST_F(PlantCheckTest, SeesFarTooManyLeaves) {
  parameters_.leaves.per_node = 0.2;
  EXPECT_THAT(objection(), HasSubstr("leaves on"));
}

TEST_F(PlantCheckTest, SeesWhatIsNoNumberAndWhatIsNotThere) {
  plant_.leaf_mesh.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(objection(), HasSubstr("not finite"));
  plant_ = make_plant(skeleton_, parameters_);
  plant_.branches.mesh.normals[2] = {0, 0, 0};
  EXPECT_THAT(objection(), HasSubstr("not of length 1"));
  plant_ = make_plant(skeleton_, parameters_);
  plant_.leaf_mesh.triangles[0][1] = 1'000'000;
  EXPECT_THAT(objection(), HasSubstr("not there"));
}

}  // namespace
}  // namespace phytobench
