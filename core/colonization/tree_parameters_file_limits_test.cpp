// SPDX-License-Identifier: MIT
// The keys of a tree file that come from [Liebemann2017]: limits of growth, round clouds, and what
// is done to the finished skeleton.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/colonization/test_growth.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/habit.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

void expect_complaint(std::string_view text, std::string_view place, std::string_view part) {
  try {
    parsed_tree(text);
    ADD_FAILURE() << "no complaint about\n" << text;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_THAT(message, StartsWith("tree.toml:" + std::string(place) + ":"));
    EXPECT_THAT(message, HasSubstr(std::string(part)));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

/// Fig. 3.2 of [Liebemann2017], its ring read as a disc, with fewer points.
constexpr const char* disc_file = R"(
random = "counter"
cloud = { shape = "disc", radius = 250, centre = [0, 250, 0], points = 500 }
stem.length = 0
tropism.weights = [0, 0, 0]
[growth]
iterations = 200
step_length = 15
perception_angle_deg = 360
influence_distance = 100
kill_distance_begin = 20
kill_distance_end = 20
)";

GrowthResult grow(const TreeParameters& parameters) {
  const auto engine = engine_named("node_driven").create();
  return grow_crown(make_seedling(parameters), *engine);
}

TEST(TreeFileLimits, ReachTheirPlaces) {
  const TreeParameters read = parsed_tree(R"(
[growth]
most_children = 3
most_branch_depth = 4
rest_iterations = 5
step_weighting = "by_branch_depth"
[variant]
influence_boundary = "exclusive"
kill_boundary = "exclusive"
[branches]
angle_reduction = 0.5
curve_reduction_deg = 60
curve_reduction_order = "root_to_tip"
)");
  EXPECT_EQ(read.limits.most_children, 3);
  EXPECT_EQ(read.limits.most_branch_depth, 4);
  EXPECT_EQ(read.limits.rest_iterations, 5);
  EXPECT_EQ(read.limits.step_weighting, StepWeighting::by_branch_depth);
  EXPECT_EQ(read.variant.influence_boundary, Boundary::exclusive);
  EXPECT_EQ(read.variant.kill_boundary, Boundary::exclusive);
  EXPECT_EQ(read.plant.angle_reduction, 0.5);
  EXPECT_EQ(read.plant.curve_reduction.cosine_above, std::cos(std::numbers::pi / 3.0));
  EXPECT_EQ(read.plant.curve_reduction.order, ReductionOrder::root_to_tip);
  const Seedling seedling = make_seedling(read);
  EXPECT_EQ(seedling.growth.limits.most_children, 3);
  EXPECT_EQ(seedling.growth.variant.kill_boundary, Boundary::exclusive);
}

TEST(TreeFileLimits, AreUnlimitedAtFirst) {
  for (const TreeParameters& read :
       {parsed_tree(""), parsed_tree("growth.most_children = inf\n")}) {
    EXPECT_EQ(read.limits.most_children, GrowthLimits::unlimited);
    EXPECT_EQ(read.limits.most_branch_depth, GrowthLimits::unlimited);
    EXPECT_EQ(read.limits.rest_iterations, GrowthLimits::unlimited);
    EXPECT_EQ(read.plant.curve_reduction.cosine_above, 1.0);
  }
}

TEST(TreeFileLimits, OfWeightsNeedADepth) {
  const std::string weights = "[growth]\nstep_weighting = \"by_branch_depth\"\n";
  expect_complaint(weights, "2", "growth.most_branch_depth = inf");
  expect_complaint(weights + "most_branch_depth = 0\n", "2", "growth.most_branch_depth = 0");
  EXPECT_NO_THROW(parsed_tree(weights + "most_branch_depth = 1\n"));
  EXPECT_NO_THROW(parsed_tree("growth.most_branch_depth = 0\n"));
}

TEST(TreeFileLimits, OfChildrenAndRestStartAtOne) {
  expect_complaint("growth.most_children = 0\n", "1", "growth.most_children = 0");
  expect_complaint("growth.rest_iterations = 0\n", "1", "growth.rest_iterations = 0");
  expect_complaint("growth.most_children = 1.5\n", "1", "growth.most_children = 1.5");
  expect_complaint("growth.most_branch_depth = -1\n", "1", "growth.most_branch_depth = -1");
}

TEST(TreeFileBoundaries, MustNotRemoveWhatNeverAttracts) {
  const std::string equal =
      "[growth]\ninfluence_distance = 1\nkill_distance_begin = 1\nkill_distance_end = 1\n";
  expect_complaint(equal + "[variant]\ninfluence_boundary = \"exclusive\"\n", "6",
                   "variant.kill_boundary");
  EXPECT_NO_THROW(parsed_tree(equal + "[variant]\nkill_boundary = \"exclusive\"\n"));
  EXPECT_NO_THROW(parsed_tree(equal + "[variant]\ninfluence_boundary = \"exclusive\"\n"
                                      "kill_boundary = \"exclusive\"\n"));
}

TEST(TreeFileRoundCloud, ReachesItsPlace) {
  for (const auto& [word, shape] : {std::pair{"disc", RoundShape::disc},
                                    {"annulus", RoundShape::annulus},
                                    {"ring", RoundShape::ring},
                                    {"sphere_shell", RoundShape::sphere_shell}}) {
    const bool hollow = shape == RoundShape::annulus || shape == RoundShape::sphere_shell;
    const TreeParameters read = parsed_tree("[cloud]\nshape = \"" + std::string(word) +
                                            "\"\nradius = 3\ncentre = [1, 2, 3]\npoints = 40\n" +
                                            (hollow ? "inner_radius = 2\n" : ""));
    ASSERT_TRUE(read.round_cloud.has_value());
    EXPECT_EQ(read.round_cloud->region.shape, shape);
    EXPECT_EQ(read.round_cloud->region.radius, 3.0);
    EXPECT_EQ(read.round_cloud->region.inner_radius, hollow ? 2.0 : 0.0);
    EXPECT_EQ(read.round_cloud->region.centre, (Vector3{1, 2, 3}));
    EXPECT_EQ(read.round_cloud->points, 40u);
    // The centre is seen from the crown root.
    const Seedling seedling = make_seedling(read);
    EXPECT_EQ(seedling.attraction_points.size(), 40u);
    const Vector3 centre = seedling.skeleton.position(seedling.crown_root) + Vector3{1, 2, 3};
    for (const Vector3& point : seedling.attraction_points)
      EXPECT_LE(norm(point - centre), 3.0 + 1e-12);
  }
}

TEST(TreeFileRoundCloud, ByDefaultGrowsATree) {
  for (const char* word : {"disc", "ring", "annulus", "sphere_shell"})
    EXPECT_GT(
        grow(parsed_tree("cloud.shape = \"" + std::string(word) + "\"\n")).skeleton.node_count(),
        5u)
        << word;
}

TEST(TreeFileRoundCloud, HasNoKeysOfTheEllipsoidAndTheOtherWayRound) {
  for (const char* key : {"radii = [1, 1, 1]", "cutoff_top = 0.1", "density = 3"})
    expect_complaint("[cloud]\nshape = \"disc\"\n" + std::string(key) + "\n", "3", "cut_ellipsoid");
  for (const char* key : {"radius = 1", "inner_radius = 1", "centre = [1, 1, 1]", "points = 3"})
    expect_complaint("[cloud]\n" + std::string(key) + "\n", "2", "round cloud.shape");
  expect_complaint("cloud.shape = \"disc\"\ntropism.damping_density = 1\n", "2", "cut_ellipsoid");
}

TEST(TreeFileRoundCloud, RefusesAHoleWhereThereIsNoneOrThatIsTooLarge) {
  expect_complaint("[cloud]\nshape = \"ring\"\ninner_radius = 1\n", "3", "annulus");
  expect_complaint("[cloud]\nshape = \"annulus\"\nradius = 1\ninner_radius = 2\n", "4",
                   "exceeds cloud.radius = 1");
}

// The circle line with the root at its centre is out of reach; the disc grows.
TEST(TreeFileRoundCloud, OfTheRingExampleDecidesWhetherAnythingGrows) {
  EXPECT_GT(grow(parsed_tree(disc_file)).skeleton.node_count(), 300u);
  std::string ring_file = disc_file;
  ring_file.replace(ring_file.find("disc"), 4, "ring");
  ring_file.replace(ring_file.find("[0, 250, 0]"), 11, "[0, 0, 0]");
  const GrowthResult result = grow(parsed_tree(ring_file));
  EXPECT_EQ(result.stop_reason, StopReason::no_point_in_range);
  EXPECT_EQ(result.skeleton.node_count(), 1u);
}

TEST(TreeFileReductions, ChangeTheSkeletonOfThePlantOnly) {
  const TreeParameters plain = parsed_tree(disc_file);
  const Skeleton grown = grow(plain).skeleton;
  const std::string file = disc_file;
  const auto dressed = [&](const char* keys) {
    return make_plant(grown, parsed_tree(file + "[branches]\n" + keys).plant).skeleton;
  };
  EXPECT_EQ(tree_hash(dressed("")), tree_hash(grown));
  const Skeleton narrower = dressed("angle_reduction = 0.5\n");
  EXPECT_EQ(narrower.parents(), grown.parents());
  EXPECT_LT(mean_turn_rad(narrower, 0), mean_turn_rad(grown, 0));
  const Skeleton coarser = dressed("curve_reduction_deg = 15\n");
  EXPECT_LT(coarser.node_count(), grown.node_count());
  EXPECT_EQ(tip_count(coarser), tip_count(grown));
  EXPECT_LT(coarser.node_count(), dressed("curve_reduction_deg = 15\n"
                                          "curve_reduction_order = \"root_to_tip\"\n")
                                      .node_count());
}

}  // namespace
}  // namespace phytobench
