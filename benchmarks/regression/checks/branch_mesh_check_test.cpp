// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/branch_mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression/checks/expected_rings.hpp"
#include "benchmarks/regression/checks/test_brush.hpp"
#include "benchmarks/regression/checks/tube_check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

class BranchMeshCheck : public testing::Test {
 protected:
  Skeleton skeleton_ = brush();
  std::vector<double> radii_ = branch_radii(skeleton_, 0.007, 1.9);
  BranchMeshOptions options_{.circle_resolution = 5};
  BranchMesh made_ = mesh_branches(skeleton_, radii_, options_);

  std::string objection() const {
    return objection_to_branch_mesh(made_, skeleton_, radii_, options_);
  }
  void make_again() { made_ = mesh_branches(skeleton_, radii_, options_); }
  TriangleMesh& mesh() { return made_.mesh; }
};

TEST_F(BranchMeshCheck, AcceptsWhatIsRightUnderAllOptions) {
  EXPECT_EQ(objection(), "");
  for (const int corners : {3, 4, 7})
    for (const double ratio : {0.0, 0.49, 1.0})
      for (const RingTurn turn : {RingTurn::from_parent, RingTurn::from_vertical})
        for (const auto single : {SingleChildNormal::bisector, SingleChildNormal::child}) {
          options_ = {.circle_resolution = corners,
                      .duplicate_ratio = ratio,
                      .ring_turn = turn,
                      .single_child_normal = single,
                      .texture_length = 0.3};
          make_again();
          EXPECT_EQ(objection(), "") << corners << " " << ratio;
        }
}

TEST_F(BranchMeshCheck, AcceptsBranchesThatFold) {
  Skeleton bent({0, 0, 0});
  bent.append(0, {0, 0.1, 0});
  bent.append(1, {0.1, 0.1, 0.01});
  bent.append(2, {0.1, 0.03, 0.02});
  const std::vector<double> radii(4, 0.2);
  EXPECT_EQ(objection_to_branch_mesh(mesh_branches(bent, radii, options_), bent, radii, options_),
            "");
}

TEST_F(BranchMeshCheck, SeesMeshesOfOtherOptions) {
  const std::vector<std::pair<BranchMeshOptions, const char*>> others = {
      {{.circle_resolution = 6}, "vertices"},
      {{.circle_resolution = 5, .duplicate_ratio = 0.0}, "duplicated"},
      {{.circle_resolution = 5, .ring_turn = RingTurn::from_vertical}, "turned away"},
      {{.circle_resolution = 5, .single_child_normal = SingleChildNormal::child}, "plane"},
      {{.circle_resolution = 5, .texture_length = 2.0}, "texture point"}};
  for (const auto& [options, what] : others) {
    made_ = mesh_branches(skeleton_, radii_, options);
    EXPECT_THAT(objection(), HasSubstr(what));
  }
}

TEST_F(BranchMeshCheck, SeesWhatIsMissingAndWhatIsNotThere) {
  mesh().triangles.pop_back();
  EXPECT_THAT(objection(), HasSubstr("triangles of branches"));
  make_again();
  mesh().positions.push_back({0, 0, 0});
  EXPECT_THAT(objection(), HasSubstr("vertices of branches"));
  make_again();
  mesh().normals.pop_back();
  EXPECT_THAT(objection(), HasSubstr("normals of branches"));
  make_again();
  mesh().triangles[0][1] = static_cast<std::uint32_t>(mesh().vertex_count());
  EXPECT_THAT(objection(), HasSubstr("not there"));
  make_again();
  ++made_.duplicated_rings;
  EXPECT_THAT(objection(), HasSubstr("duplicated rings"));
}

TEST_F(BranchMeshCheck, SeesVerticesOffTheirCircle) {
  Vector3& corner = mesh().positions[8];  // corner 2 of ring 1
  const Vector3 center = skeleton_.positions()[1], right = corner;
  corner = center + 1.000001 * (right - center);
  EXPECT_THAT(objection(), HasSubstr("vertex 8, corner 2 of ring 1"));
  corner = right;
  Vector3& of_duplicate = mesh().positions.back();
  of_duplicate.x += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("not at the radius"));
  make_again();
  std::swap(mesh().positions[7], mesh().positions[8]);
  EXPECT_THAT(objection(), HasSubstr("vertex 7, corner 1 of ring 1: turned away"));
}

/// All corners of one ring, as a wrong rotation would have them.
TEST_F(BranchMeshCheck, SeesARingThatIsTurned) {
  const Vector3 center = skeleton_.positions()[2];
  const auto turn_ring = [&](const Vector3& axis) {
    make_again();
    const Rotation little = Rotation::about(axis / norm(axis), 1e-6);
    for (std::size_t v = 12; v < 18; ++v)
      mesh().positions[v] = center + little(mesh().positions[v] - center);
  };
  const auto looks = expected_rings(skeleton_, radii_, options_).rings[2].looks;
  turn_ring({looks.x, looks.y, looks.z});
  EXPECT_THAT(objection(), HasSubstr("ring 2: turned away"));
  turn_ring(any_perpendicular({looks.x, looks.y, looks.z}));
  EXPECT_THAT(objection(), HasSubstr("ring 2: not in the ring's plane"));
}

TEST_F(BranchMeshCheck, SeesAnOpenSeam) {
  mesh().positions[5].y = std::nextafter(mesh().positions[5].y, 9.0);
  EXPECT_THAT(objection(), HasSubstr("ring 0 is open at its seam"));
}

TEST_F(BranchMeshCheck, SeesTrianglesOfOtherCorners) {
  mesh().triangles[3] = mesh().triangles[4];
  EXPECT_THAT(objection(), HasSubstr("not those of tubes"));
  make_again();
  mesh().triangles[0][2] += 1;
  EXPECT_THAT(objection(), AnyOf(HasSubstr("not those of tubes"), HasSubstr("across its seam")));
  make_again();
  for (Triangle& triangle : mesh().triangles)
    for (std::uint32_t& vertex : triangle)
      if (vertex % 6 == 5) vertex -= 5;  // the right places, but the texture runs back
  EXPECT_THAT(objection(), HasSubstr("across its seam"));
}

TEST_F(BranchMeshCheck, SeesAnotherNumberOfOpenSides) {
  ExpectedRings expected = expected_rings(skeleton_, radii_, options_);
  EXPECT_EQ(objection_to_tubes(mesh(), expected, options_.circle_resolution), "");
  ++expected.duplicated;
  EXPECT_THAT(objection_to_tubes(mesh(), expected, options_.circle_resolution),
              HasSubstr("sides belong to one triangle only"));
}

TEST_F(BranchMeshCheck, DoesNotMindTheOrderOfTriangles) {
  std::reverse(mesh().triangles.begin(), mesh().triangles.end());
  for (Triangle& triangle : mesh().triangles)
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  EXPECT_EQ(objection(), "");
}

TEST_F(BranchMeshCheck, SeesTrianglesThatLookInward) {
  for (const std::size_t which : {0u, 1u, 77u, 300u}) {
    make_again();
    std::swap(mesh().triangles[which][0], mesh().triangles[which][2]);
    EXPECT_THAT(objection(), HasSubstr("looks inward")) << which;
  }
}

TEST_F(BranchMeshCheck, SeesANormalThatIsNotThatOfItsTriangles) {
  for (const std::size_t v : {std::size_t{0}, std::size_t{20}, mesh().vertex_count() - 1}) {
    make_again();
    mesh().normals[v] = Rotation::about({0, 1, 0}, 1e-6)(mesh().normals[v]);
    EXPECT_THAT(objection(), HasSubstr("not that of its triangles")) << v;
  }
}

/// A tube of four hexagons; a fork; a fork whose thin branch has a ring of its own.
TEST(ExpectedRings, KnowWhichRingsAreOpen) {
  Skeleton tree({0, 0, 0});
  for (int i = 0; i < 3; ++i) tree.append(i, {0.1 * i, i + 1.0, 0.0});
  const BranchMeshOptions options;
  EXPECT_EQ(expected_rings(tree, std::vector<double>(4, 1.0), options).open_rings(), 2u);
  tree.append(1, {1.0, 2.0, 0.0});
  EXPECT_EQ(expected_rings(tree, std::vector<double>(5, 1.0), options).open_rings(), 3u);
  const std::vector<double> radii{1.0, 1.0, 1.0, 1.0, 0.4};
  EXPECT_EQ(expected_rings(tree, radii, options).duplicated, 1u);
  EXPECT_EQ(expected_rings(tree, radii, options).open_rings(), 4u);
}

}  // namespace
}  // namespace phytobench
