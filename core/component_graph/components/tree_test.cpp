// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

/// Stands in the world so that its axis leans from the vertical, in the plane of y and z.
Tried leaning_tree(double degrees_from_up) {
  Tried tree("tree");
  tree.frame = outward_frame({3.0, 1.0, -2.0}, 0.0, degrees_from_up);
  return tree;
}

double end_angle_to_weight(const Tried& tree) {
  return angle_deg(tree.frame.direction(tree.child().y), {0.0, -1.0, 0.0});
}

TEST(Tree, WithoutTropismsIsAHorn) {
  Tried tree("tree"), horn("horn");
  for (Tried* one : {&tree, &horn}) one->set("bend_first", 6.0).set("bend_last", -9.0);
  EXPECT_EQ(tree.mesh().positions, horn.mesh().positions);
  EXPECT_EQ(tree.mesh().triangles, horn.mesh().triangles);
  EXPECT_EQ(tree.child(), horn.child());
}

/// In a constant field d(angle) / ds = -w sin(angle).
TEST(TreeLaw, TheTangentOfHalfTheAngleFallsExponentially) {
  for (const double segments : {1.0, 5.0, 40.0}) {
    for (const double weight : {-90.0, 20.0, 200.0, 5000.0}) {
      Tried tree = leaning_tree(30.0);
      tree.set("segments", segments).set("gravitropism", weight);
      const double half = std::atan(std::tan(radians(75.0)) * std::exp(-radians(weight)));
      EXPECT_NEAR(end_angle_to_weight(tree), 2.0 * degrees(half), 1e-9)
          << segments << ' ' << weight;
    }
  }
}

TEST(TreeLaw, ItsEndMovesAsideByTheTurnOverTheWeight) {
  Tried tree = leaning_tree(40.0);
  tree.set("segments", 800.0).set("length", 2.0).set("gravitropism", 150.0);
  const double turned = radians(140.0 - end_angle_to_weight(tree));
  const Vector3 way = tree.frame.direction(tree.child().origin);
  EXPECT_NEAR(way.z, 2.0 * turned / radians(150.0), 2e-6);
  EXPECT_NEAR(way.x, 0.0, 1e-12);
}

TEST(Tree, LightAndWeightPullEquallyAgainstEachOther) {
  Tried tree = leaning_tree(40.0);
  tree.set("phototropism", 90.0);
  EXPECT_LT(angle_deg(tree.frame.direction(tree.child().y), {0, 1, 0}), 20.0);
  tree.set("gravitropism", 90.0);
  EXPECT_LT(angle_deg(tree.child().y, {0, 1, 0}), 1e-9);
  tree.set("phototropism", 0.0).set("gravitropism", -90.0);
  EXPECT_LT(angle_deg(tree.frame.direction(tree.child().y), {0, 1, 0}), 20.0);
}

TEST(Tree, ExactlyAgainstItsPullItStays) {
  Tried tree("tree");
  EXPECT_EQ(tree.set("gravitropism", 90.0).child().origin, (Vector3{0.0, 1.0, 0.0}));
}

TEST(Tree, BranchesStandBetweenTwoSharesAtTheirTilt) {
  Tried tree("tree");
  tree.set("length", 2.0).set("branches", 5.0).set("branch_from", 0.2).set("branch_to", 0.6);
  tree.set_range("branch_tilt", 80.0, 40.0).set_range("branch_scale", 0.9, 0.5);
  EXPECT_EQ(tree.branches(), 5u);
  const auto frames = tree.frames(LinkKind::branch, 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double k = static_cast<double>(i);
    EXPECT_LT(norm(frames[i].origin - Vector3{0.0, 0.4 + 0.2 * k, 0.0}), 1e-12);
    EXPECT_NEAR(angle_deg(frames[i].y, {0, 1, 0}), 80.0 - 10.0 * k, 1e-9);
    EXPECT_NEAR(frames[i].scale, 0.9 - 0.1 * k, 1e-12);
  }
}

TEST(TreeLaw, BranchesTurnByTheGoldenAngleUnlessToldOtherwise) {
  for (const double step : {golden_angle_deg, 90.0}) {
    Tried tree("tree");
    if (step == 90.0) tree.set("azimuth_step", step);
    const auto frames = tree.frames(LinkKind::branch, 8);
    for (std::size_t i = 1; i < 8; ++i) {
      const Vector3 a{frames[i - 1].y.x, 0, frames[i - 1].y.z}, b{frames[i].y.x, 0, frames[i].y.z};
      EXPECT_NEAR(angle_deg(a, b), step, 1e-9);
    }
  }
}

TEST(Tree, BranchesOfABentStemKeepTheirTiltToThePieceTheyStandOn) {
  Tried tree("tree");
  tree.set("bend_first", 10.0).set("bend_last", 10.0).set("branch_tilt", 60.0);
  tree.set("segments", 10.0).set("branch_from", 0.05).set("branch_to", 0.95);
  const auto frames = tree.frames(LinkKind::branch, 10);  // one in the middle of each piece
  for (std::size_t i = 0; i < 10; ++i) {
    const double turn = radians(10.0 * static_cast<double>(i));
    EXPECT_NEAR(angle_deg(frames[i].y, {0.0, std::cos(turn), std::sin(turn)}), 60.0, 1e-9);
  }
}

TEST(Tree, ShiftedBranchesStayOnTheStem) {
  Tried tree("tree");
  tree.set("branch_shift", 0.9).set("branch_from", 0.5).set("branch_to", 0.5);
  EXPECT_EQ(tree.frames(LinkKind::branch, 3)[1].origin.y, 1.0);
  tree.set("branch_shift", -0.9);
  EXPECT_EQ(tree.frames(LinkKind::branch, 3)[1].origin.y, 0.0);
}

TEST(Tree, CrookednessDependsOnTheInstanceOnly) {
  Tried tree("tree");
  tree.set("crookedness", 20.0);
  const Frame end = tree.child();
  EXPECT_EQ(tree.child(), end);
  tree.context.resolution = 0.3;
  EXPECT_EQ(tree.child(), end);
  EXPECT_NE(end.origin.y, 1.0);
  tree.place.identity = 17;
  EXPECT_NE(tree.child(), end);
  EXPECT_LT(angle_deg(end.y, {0, 1, 0}), 7.0 * 20.0);
}

TEST(TreeLaw, TwiceTheLengthsAreTwiceThePlaces) {
  Tried small("tree"), large("tree");
  for (Tried* tree : {&small, &large}) {
    tree->frame = outward_frame({0.0, 0.0, 0.0}, 20.0, 50.0);
    tree->set("crookedness", 12.0).set("gravitropism", 80.0).set("bend_first", 3.0);
  }
  large.set("length", 2.0).set("radius_first", 0.1).set("radius_last", 0.02);
  const TriangleMesh a = small.mesh(), b = large.mesh();
  for (std::size_t i = 0; i < a.vertex_count(); ++i)
    EXPECT_EQ(2.0 * a.positions[i], b.positions[i]);
  const auto c = small.frames(LinkKind::branch, 4), d = large.frames(LinkKind::branch, 4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(2.0 * c[i].origin, d[i].origin);
}

TEST(Tree, IsClosedHoweverItIsBent) {
  Tried tree = leaning_tree(70.0);
  tree.set("gravitropism", 400.0).set("crookedness", 10.0);
  EXPECT_TRUE(SurfaceEdges(tree.mesh()).is_closed());
  EXPECT_GT(enclosed_volume(tree.mesh()), 0.0);
}

}  // namespace
}  // namespace phytobench
