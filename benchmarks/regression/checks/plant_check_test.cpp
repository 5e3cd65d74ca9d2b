// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/plant_check.hpp"

#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression/checks/test_brush.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

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
  parameters_.branches = {.circle_resolution = 6, .duplicate_ratio = 0.1};
  parameters_.leaves = {.per_node = 2.3, .shape = LeafShape::square};
  plant_ = make_plant(skeleton_, parameters_);
  EXPECT_EQ(objection(), "");
}

TEST_F(PlantCheckTest, SeesAnotherSkeleton) {
  plant_.skeleton.append(0, {0, 0, 1});
  EXPECT_THAT(objection(), HasSubstr("skeleton"));
}

TEST_F(PlantCheckTest, SeesARadiusThatDoesNotFollowTheRule) {
  plant_.radii[1] *= 1.001;
  EXPECT_THAT(objection(), HasSubstr("node 0: radius"));
  plant_.radii.pop_back();
  EXPECT_THAT(objection(), HasSubstr("radii of"));
}

TEST_F(PlantCheckTest, SeesWhatIsNoNumber) {
  plant_.leaf_mesh.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(objection(), HasSubstr("vertex 3 is not finite"));
  plant_ = make_plant(skeleton_, parameters_);
  plant_.branches.mesh.normals[2] = {0, 0, 0};
  EXPECT_THAT(objection(), HasSubstr("vertex 2 is not of length 1"));
}

TEST_F(PlantCheckTest, SeesATriangleTooFew) {
  plant_.branches.mesh.triangles.pop_back();
  EXPECT_THAT(objection(), HasSubstr("triangles are those of"));
  plant_ = make_plant(skeleton_, parameters_);
  plant_.leaf_mesh.triangles.pop_back();
  EXPECT_THAT(objection(), HasSubstr("triangles are those of"));
}

/// One of each check that it calls.
TEST_F(PlantCheckTest, SeesWhatIsWrongWithItsParts) {
  plant_.branches.mesh.positions[5].x += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("vertex 5, corner 1 of ring 1"));
  plant_ = make_plant(skeleton_, parameters_);
  std::swap(plant_.branches.mesh.triangles[9][0], plant_.branches.mesh.triangles[9][2]);
  EXPECT_THAT(objection(), HasSubstr("looks inward"));
  plant_ = make_plant(skeleton_, parameters_);
  std::swap(plant_.leaf_mesh.texture_points[0], plant_.leaf_mesh.texture_points[1]);
  EXPECT_THAT(objection(), HasSubstr("whole texture"));
  plant_ = make_plant(skeleton_, parameters_);
  parameters_.leaves.per_node = 0.2;
  EXPECT_THAT(objection(), HasSubstr("leaves on"));
}

}  // namespace
}  // namespace phytobench
