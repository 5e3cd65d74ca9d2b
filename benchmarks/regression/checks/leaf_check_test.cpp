// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/leaf_check.hpp"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression/checks/test_brush.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

class LeafCheck : public testing::Test {
 protected:
  Skeleton skeleton_ = brush();
  std::vector<double> radii_ = branch_radii(skeleton_, 0.007, 1.9);
  LeafOptions options_{.per_node = 2.4};
  std::vector<Leaf> leaves_ = make_leaves(skeleton_, radii_, options_);
  TriangleMesh mesh_ = mesh_leaves(leaves_, options_.shape);

  std::string objection() const {
    return objection_to_leaves(leaves_, skeleton_, radii_, options_);
  }
  std::string mesh_objection() const {
    return objection_to_leaf_mesh(mesh_, leaves_, options_.shape);
  }
};

TEST_F(LeafCheck, AcceptsWhatIsRight) {
  ASSERT_GT(leaves_.size(), 200u);
  EXPECT_EQ(objection(), "");
  EXPECT_EQ(mesh_objection(), "");
  options_.shape = LeafShape::square;
  mesh_ = mesh_leaves(leaves_, options_.shape);
  EXPECT_EQ(mesh_objection(), "");
  for (const double per_node : {0.0, 0.7, 3.0}) {
    options_.per_node = per_node;
    leaves_ = make_leaves(skeleton_, radii_, options_);
    EXPECT_EQ(objection(), "") << per_node;
  }
}

TEST_F(LeafCheck, SeesFarTooManyLeavesAndOneAtTheWrongNode) {
  options_.per_node = 2.0;
  EXPECT_THAT(objection(), HasSubstr("leaves on"));
  options_.per_node = 2.4;
  std::swap(leaves_[0], leaves_[200]);
  EXPECT_NE(objection(), "");
}

TEST_F(LeafCheck, SeesALeafBesideItsBranch) {
  leaves_[40].position.y += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("leaf 40 is not on the edge"));
}

TEST_F(LeafCheck, SeesLeavesOfAnotherSizeAndWithout) {
  options_.size *= 1.1;
  EXPECT_THAT(objection(), HasSubstr("mean size"));
  options_.size /= 1.1;
  leaves_[3].size = 0.0;
  EXPECT_THAT(objection(), HasSubstr("leaf 3 has size"));
}

TEST_F(LeafCheck, SeesLeavesThatCrowdAtTheEndsOfTheirBranches) {
  for (Leaf& leaf : leaves_)
    for (std::size_t node = 1; node < radii_.size(); ++node) {
      const Vector3 from = skeleton_.position(skeleton_.parents()[node]),
                    edge = skeleton_.positions()[node] - from;
      const double share = dot(leaf.position - from, edge) / squared_norm(edge);
      if (norm(from + share * edge - leaf.position) > 1e-12 || share < 0.0 || share > 1.0) continue;
      leaf.position = from + (0.5 + 0.5 * share) * edge;
      break;
    }
  EXPECT_THAT(objection(), HasSubstr("not spread"));
}

TEST_F(LeafCheck, SeesAMeshThatLacksSomething) {
  mesh_.triangles.pop_back();
  EXPECT_THAT(mesh_objection(), HasSubstr("triangles of leaves"));
  mesh_ = mesh_leaves(leaves_, options_.shape);
  mesh_.texture_points.pop_back();
  EXPECT_THAT(mesh_objection(), HasSubstr("texture points of leaves"));
}

TEST_F(LeafCheck, SeesSquaresOutOfShapeAndOutOfPlace) {
  mesh_.positions[7].x += 1e-6;
  EXPECT_THAT(mesh_objection(), HasSubstr("square 0 of leaf 0 is no square"));
  mesh_ = mesh_leaves(leaves_, options_.shape);
  for (std::size_t v = 16; v < 24; ++v) mesh_.positions[v].z += 1e-6;
  EXPECT_THAT(mesh_objection(), HasSubstr("square 0 of leaf 1 is no square"));
  mesh_ = mesh_leaves(leaves_, options_.shape);
  leaves_[2].turned = leaves_[3].turned;
  EXPECT_THAT(mesh_objection(), HasSubstr("square 0 of leaf 2 is not turned"));
}

TEST_F(LeafCheck, SeesSidesThatFaceTheWrongWay) {
  std::swap(mesh_.triangles[1][0], mesh_.triangles[1][1]);
  EXPECT_THAT(mesh_objection(), HasSubstr("two triangles that face as it does"));
  mesh_ = mesh_leaves(leaves_, options_.shape);
  mesh_.triangles[1] = mesh_.triangles[0];
  EXPECT_THAT(mesh_objection(), HasSubstr("covered by two triangles"));
  mesh_.triangles[1] = {4, 5, 6};
  EXPECT_THAT(mesh_objection(), HasSubstr("covered by two triangles"));
  mesh_ = mesh_leaves(leaves_, options_.shape);
  for (std::size_t v = 4; v < 8; ++v) mesh_.normals[v] = mesh_.normals[0];
  EXPECT_THAT(mesh_objection(), HasSubstr("leaf 0"));
}

TEST_F(LeafCheck, SeesATextureThatIsTurnedOver) {
  std::swap(mesh_.texture_points[0], mesh_.texture_points[1]);
  EXPECT_THAT(mesh_objection(), HasSubstr("whole texture"));
}

}  // namespace
}  // namespace phytobench
