// SPDX-License-Identifier: MIT
#include "core/colonization/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/colonization/test_growth.hpp"
#include "core/colonization/tree_parameters.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

GrowthRun with_option(std::string_view name) {
  return {.options = loop_options_named(name)};
}

/// A root at the origin that looks upwards and perceives within 80 degrees of that; no tropism.
Seedling scene(std::vector<Vector3> points, int iterations, double influence_distance,
               double kill_distance) {
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.growth = {.iterations = iterations,
                     .step_length = 0.25,
                     .influence_distance = influence_distance,
                     .perception_angle_rad = 2.0 * half_angle_rad,
                     .kill_distance = {.begin = kill_distance, .end = kill_distance},
                     .tropism = {},
                     .variant = {}};
  return seedling;
}

template <class Field>
Field total(const GrowthResult& result, Field PassStatistics::*field) {
  Field sum = 0;
  for (const PassStatistics& pass : result.passes) sum += pass.*field;
  return sum;
}

auto children_of_root(const Skeleton& skeleton) {
  return std::count(skeleton.parents().begin(), skeleton.parents().end(), 0);
}

TEST(GrowCrown, StopsAtTheIterationLimit) {
  const GrowthResult result = grow(scene({{0, 3, 0}}, 2, 5.0, 0.1));
  EXPECT_EQ(result.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(result.passes.size(), 2u);
  EXPECT_EQ(result.skeleton.node_count(), 3u);
  EXPECT_EQ(result.skeleton.positions().back(), (Vector3{0, 0.5, 0}));
}

TEST(GrowCrown, StopsIfNoPointIsInRange) {
  const GrowthResult result = grow(scene({{0, 10, 0}}, 9, 0.5, 0.3));
  EXPECT_EQ(result.stop_reason, StopReason::no_point_in_range);
  EXPECT_EQ(result.passes.size(), 1u);
  EXPECT_EQ(result.skeleton.node_count(), 1u);
  EXPECT_EQ(result.live_points, 1u);
}

TEST(GrowCrown, StopsIfThereIsNoPointAtAll) {
  for (const std::string_view name : loop_option_names) {
    const GrowthResult result = grow(scene({}, 9, 0.5, 0.3), with_option(name));
    EXPECT_EQ(result.stop_reason, StopReason::no_point_in_range) << name;
    EXPECT_EQ(result.skeleton.node_count(), 1u) << name;
  }
}

TEST(GrowCrown, StopsIfNoPointIsLeft) {
  for (const std::string_view name : loop_option_names) {
    const GrowthResult result = grow(scene({{0, 0.4, 0}}, 9, 0.5, 0.3), with_option(name));
    EXPECT_EQ(result.stop_reason, StopReason::no_points_left) << name;
    EXPECT_EQ(result.skeleton.node_count(), 2u) << name;
    EXPECT_EQ(result.live_points, 0u) << name;
  }
}

// Two points at the edge of the angle stay nearest to the origin whatever grows between them.
TEST(GrowCrown, StopsIfEveryChildWouldRepeatOne) {
  const GrowthResult result = grow(scene({{-0.4, 0.08, 0}, {0.4, 0.08, 0}}, 10, 0.5, 0.3));
  EXPECT_EQ(result.stop_reason, StopReason::no_new_node);
  EXPECT_EQ(children_of_root(result.skeleton), 1);
  ASSERT_EQ(result.passes.size(), 2u);
  EXPECT_EQ(result.passes[0].suppressed_repeats, 0u);
  EXPECT_EQ(result.passes[1].suppressed_repeats, 1u);
  EXPECT_EQ(result.passes[1].associated_points, 2u);
}

TEST(GrowCrown, RepeatsAChildWithoutTheGuard) {
  Seedling seedling = scene({{-0.4, 0.08, 0}, {0.4, 0.08, 0}}, 10, 0.5, 0.3);
  seedling.growth.variant.repeat_guard = RepeatGuard::off;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(result.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(children_of_root(result.skeleton), 10);
}

TEST(GrowCrown, StopsWhenTheObserverSaysSo) {
  int calls = 0;
  const GrowthResult result =
      grow(scene({{0, 9, 0}}, 20, 50.0, 0.1),
           {.observer = [&](const PassStatistics&) { return ++calls < 3; }});
  EXPECT_EQ(result.stop_reason, StopReason::interrupted);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(result.passes.size(), 3u);
  EXPECT_EQ(result.skeleton.edge_count(), 3u);
}

TEST(GrowCrown, ObserverSeesEveryPassOnce) {
  std::vector<int> seen;
  const GrowthResult result =
      grow(scene({{0, 9, 0}}, 5, 50.0, 0.1), {.observer = [&](const PassStatistics& pass) {
             seen.push_back(pass.iteration);
             return true;
           }});
  EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(result.passes.size(), 5u);
}

// [Brzoska2019] fig. 18 in our own coordinates: six nodes in a row, two points to the left, two
// above.
TEST(GrowCrown, GrowsTheExampleOfTheThesis) {
  Seedling seedling =
      scene({{-1.5, 3.2, 0}, {-1.4, 3.4, 0}, {0.8, 6.8, 0}, {1.2, 7.0, 0}}, 1, 2.6, 0.8);
  seedling.growth.step_length = 1.0;
  seedling.growth.perception_angle_rad = 2.0 * std::numbers::pi;
  for (std::int32_t i = 0; i < 5; ++i) seedling.skeleton.append(i, {0.0, i + 1.0, 0.0});
  const GrowthResult result = grow(seedling);
  ASSERT_EQ(result.skeleton.node_count(), 8u);
  EXPECT_EQ(result.skeleton.parents()[6], 3);
  EXPECT_EQ(result.skeleton.parents()[7], 5);
  EXPECT_LT(result.skeleton.positions()[6].x, -0.9);
  EXPECT_GT(result.skeleton.positions()[7].x, 0.3);
  EXPECT_EQ(result.live_points, 2u);
}

TEST(GrowCrown, RemovesAPointExactlyAtTheKillDistance) {
  // The child stands exactly at (0, 0.25, 0).
  EXPECT_EQ(grow(scene({{0, 0.5, 0}}, 1, 0.55, 0.25)).live_points, 0u);
  EXPECT_EQ(grow(scene({{0, 0.5, 0}}, 1, 0.55, 0.2499)).live_points, 1u);
}

TEST(GrowCrown, IsAttractedFromExactlyTheInfluenceDistance) {
  EXPECT_EQ(grow(scene({{0, 0.5, 0}}, 1, 0.5, 0.1)).skeleton.edge_count(), 1u);
  EXPECT_EQ(grow(scene({{0, 0.5, 0}}, 1, std::nextafter(0.5, 0.0), 0.1)).skeleton.edge_count(), 0u);
}

TEST(GrowCrown, ReachesAnyPointWithoutInfluenceLimit) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(grow(scene({{0, 1e6, 0}}, 3, infinity, 0.1)).skeleton.edge_count(), 3u);
}

TEST(GrowCrown, PointAtTheNodeItselfGivesNoDirection) {
  const GrowthResult result = grow(scene({{0, 0, 0}}, 3, 0.5, 0.1));
  EXPECT_EQ(result.skeleton.edge_count(), 0u);
  EXPECT_EQ(result.stop_reason, StopReason::no_new_node);
}

TEST(GrowCrown, LeavesTheLastRemovalUndoneWithOptionD) {
  const Seedling seedling = scene({{0, 0.4, 0}}, 1, 0.5, 0.3);
  EXPECT_EQ(grow(seedling, with_option("s")).live_points, 0u);
  const GrowthResult result = grow(seedling, with_option("d"));
  EXPECT_EQ(result.live_points, 1u);
  EXPECT_EQ(result.stop_reason, StopReason::iteration_limit);
}

TEST(GrowCrown, CrownRootRemovesPointsInTheFirstIteration) {
  // The first point lies below the root: near to it, far from the child and unperceived.
  const GrowthResult result = grow(scene({{0.1, -0.2, 0}, {0, 0.9, 0}}, 1, 1.0, 0.3));
  ASSERT_EQ(result.passes.size(), 1u);
  EXPECT_EQ(result.passes[0].removed_points, 1u);
  EXPECT_EQ(result.live_points, 1u);
}

TEST(GrowCrown, StemInsideTheCrownRemovesPointsOnlyIfAsked) {
  // The second point lies near the stem's upper node, which does not perceive it.
  Seedling seedling = scene({{0, 1.4, 0}, {0.2, 0.85, 0}}, 1, 1.0, 0.3);
  seedling.skeleton.append(0, {0, 1, 0});
  EXPECT_EQ(grow(seedling).live_points, 1u);
  seedling.growth.variant.start_killers = StartKillers::crown_stem_too;
  EXPECT_EQ(grow(seedling).live_points, 0u);
}

TEST(GrowCrown, StemBelowTheCrownIsNotSearched) {
  Seedling seedling = scene({{0.2, 0.2, 0}}, 3, 0.5, 0.3);
  EXPECT_EQ(grow(seedling).skeleton.edge_count(), 1u);
  seedling.crown_root = seedling.skeleton.append(0, {0, 1, 0});
  EXPECT_EQ(grow(seedling).stop_reason, StopReason::no_point_in_range);
}

TEST(GrowCrown, TestsTheAngleDuringTheSearchOrAfterIt) {
  // The upper node is nearer but looks away; the lower one perceives the point.
  Seedling seedling = scene({{0.5, 0.9, 0}}, 1, 1.5, 0.1);
  seedling.skeleton.append(0, {0, 1, 0});
  const GrowthResult during = grow(seedling);
  ASSERT_EQ(during.skeleton.node_count(), 3u);
  EXPECT_EQ(during.skeleton.parents()[2], 0);
  seedling.growth.variant.perception_test = PerceptionTest::after_search;
  const GrowthResult after = grow(seedling);
  EXPECT_EQ(after.skeleton.node_count(), 2u);
  EXPECT_EQ(after.stop_reason, StopReason::no_point_in_range);
}

TEST(GrowCrown, DeferredFirstPassMayRemoveWhatTheCrownRootReaches) {
  Seedling seedling = scene({{0, 0.2, 0}}, 3, 0.5, 0.3);
  EXPECT_EQ(grow(seedling, with_option("d")).skeleton.edge_count(), 1u);
  seedling.growth.variant.deferred_first_pass = DeferredFirstPass::kill;
  const GrowthResult result = grow(seedling, with_option("d"));
  EXPECT_EQ(result.skeleton.edge_count(), 0u);
  EXPECT_EQ(result.live_points, 0u);
}

TEST(GrowCrown, DeferredRemovalWithTheWrongDistanceGrowsAnotherTree) {
  Seedling seedling = make_seedling(small_tree());
  const std::string right = tree_hash(grow(seedling, with_option("d")).skeleton);
  seedling.growth.variant.deferred_kill_distance = DeferredKillDistance::current_iteration;
  EXPECT_NE(tree_hash(grow(seedling, with_option("d")).skeleton), right);
}

TEST(GrowCrown, BoxSparesQueriesOfFarPoints) {
  const GrowthResult result = grow(make_seedling(small_tree()), with_option("n"));
  EXPECT_LT(result.passes.front().queried_points, result.passes.front().live_points);
  EXPECT_GT(total(result, &PassStatistics::queried_points), 0u);
}

TEST(GrowCrown, RefusesToKillBeyondTheInfluenceDistance) {
  Seedling seedling = scene({{0, 0.4, 0}}, 3, 0.5, 0.3);
  seedling.growth.kill_distance.begin = 0.6;
  EXPECT_THROW(grow(seedling), ContractViolation);
  seedling.growth.kill_distance = {.begin = 0.3, .end = 0.6};
  EXPECT_THROW(grow(seedling), ContractViolation);
}

TEST(StartNodes, AreCrownRootAndStemInsideTheCrown) {
  Seedling seedling;
  seedling.crown_root = seedling.skeleton.append(0, {0, 1, 0});
  seedling.crown_root_direction = {0, 0, 1};
  seedling.skeleton.append(1, {2, 1, 0});
  const std::vector<SearchableNode> nodes = start_nodes(seedling);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].position, (Vector3{0, 1, 0}));
  EXPECT_EQ(nodes[0].direction, (Vector3{0, 0, 1}));
  EXPECT_EQ(nodes[1].position, (Vector3{2, 1, 0}));
  EXPECT_EQ(nodes[1].direction, (Vector3{1, 0, 0}));
}

TEST(StopReasonName, IsDifferentForEachReason) {
  std::set<std::string_view> names;
  for (const StopReason reason :
       {StopReason::iteration_limit, StopReason::no_points_left, StopReason::no_point_in_range,
        StopReason::no_new_node, StopReason::no_child_allowed, StopReason::every_node_rests,
        StopReason::interrupted})
    names.insert(name_of(reason));
  EXPECT_EQ(names.size(), 7u);
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(GrowthLaw, LoopOptionsGrowTheSameTree) {
  const Seedling seedling = make_seedling(small_tree());
  const GrowthResult plain = grow(seedling);
  EXPECT_GT(plain.skeleton.edge_count(), 100u);
  for (const std::string_view name : loop_option_names)
    EXPECT_EQ(tree_hash(grow(seedling, with_option(name)).skeleton), tree_hash(plain.skeleton))
        << name;
}

TEST(GrowthLaw, ThreadsChangeNeitherTreeNorWork) {
  const Seedling seedling = make_seedling(small_tree());
  for (const char* name : {"s", "dn"}) {
    GrowthRun run = with_option(name);
    const GrowthResult one = grow(seedling, run);
    for (const int threads : {1, 2, 3}) {
      run.threads = threads;
      const GrowthResult several = grow(seedling, run);
      EXPECT_EQ(tree_hash(several.skeleton), tree_hash(one.skeleton)) << threads << " threads";
      EXPECT_EQ(several.work, one.work) << threads << " threads";
    }
  }
}

TEST(GrowthLaw, EnginesGrowTheSameTree) {
  const Seedling seedling = make_seedling(small_tree());
  const std::string expected = tree_hash(grow(seedling).skeleton);
  for (const EngineDescriptor* descriptor : all_engines()) {
    if (!descriptor->built()) continue;
    const auto engine = descriptor->create();
    EXPECT_EQ(tree_hash(grow_crown(seedling, *engine).skeleton), expected) << descriptor->name;
  }
}

TEST(GrowthLaw, EngineForgetsTheTreeBefore) {
  const Seedling seedling = make_seedling(small_tree());
  const Seedling other = scene({{0, 3, 0}}, 2, 5.0, 0.1);
  const auto engine = engine_named("squared_scan").create();
  const GrowthResult first = grow_crown(seedling, *engine);
  ASSERT_EQ(grow_crown(other, *engine).skeleton.edge_count(), 2u);
  const GrowthResult again = grow_crown(seedling, *engine);
  EXPECT_EQ(tree_hash(again.skeleton), tree_hash(first.skeleton));
  EXPECT_EQ(again.work, first.work);
}

TEST(GrowthLaw, PassesAddUpToTheTotals) {
  const Seedling seedling = make_seedling(small_tree());
  for (const std::string_view name : loop_option_names) {
    const GrowthResult result = grow(seedling, with_option(name));
    ASSERT_EQ(result.stop_reason, StopReason::iteration_limit) << name;
    EXPECT_EQ(total(result, &PassStatistics::search_evaluations), result.work.search_evaluations)
        << name;
    EXPECT_EQ(total(result, &PassStatistics::kill_evaluations), result.work.kill_evaluations)
        << name;
    EXPECT_EQ(total(result, &PassStatistics::queried_points), result.work.queries) << name;
    EXPECT_EQ(total(result, &PassStatistics::new_nodes),
              result.skeleton.edge_count() - seedling.skeleton.edge_count())
        << name;
    EXPECT_EQ(total(result, &PassStatistics::removed_points) + result.live_points,
              seedling.attraction_points.size())
        << name;
    EXPECT_EQ(result.passes.back().searchable_nodes, result.work.index_updates) << name;
  }
}

TEST(GrowthLaw, PlainScanComparesEveryQueriedPointWithEveryNode) {
  const Seedling seedling = make_seedling(small_tree());
  for (const std::string_view name : loop_option_names) {
    const GrowthResult result = grow(seedling, with_option(name));
    for (const PassStatistics& pass : result.passes) {
      ASSERT_LE(pass.queried_points, pass.live_points) << name;
      if (loop_options_named(name).point_filter == PointFilter::none) {
        ASSERT_EQ(pass.queried_points, pass.live_points) << name;
      }
      ASSERT_EQ(pass.search_evaluations, pass.queried_points * pass.searchable_nodes) << name;
    }
  }
}

TEST(GrowthLaw, ImmediateRemovalComparesEveryPointWithEveryNewNode) {
  const GrowthResult result = grow(make_seedling(small_tree()));
  for (const PassStatistics& pass : result.passes) {
    // The crown root removes points once as well.
    const std::size_t killers = pass.new_nodes + (pass.iteration == 0 ? 1u : 0u);
    ASSERT_EQ(pass.kill_evaluations, pass.live_points * killers) << "iteration " << pass.iteration;
  }
}

TEST(GrowthLaw, EveryCrownEdgeIsOneStepWithinTheConeOfItsParent) {
  const Seedling seedling = make_seedling(small_tree());
  const Skeleton tree = grow(seedling).skeleton;
  constexpr double rounding = 1e-12;  // positions below 10, steps of 0.25
  for (auto i = static_cast<std::size_t>(seedling.crown_root) + 1; i < tree.node_count(); ++i) {
    const auto parent = static_cast<std::size_t>(tree.parents()[i]);
    const Vector3 step = tree.positions()[i] - tree.positions()[parent];
    const Vector3 step_before = tree.positions()[parent] - tree.position(tree.parents()[parent]);
    ASSERT_NEAR(norm(step), 0.25, rounding) << "node " << i;
    ASSERT_GE(dot(step, step_before) / (0.25 * 0.25), std::cos(half_angle_rad) - rounding)
        << "node " << i;
  }
}

/// A seedling without stem, whose tree is symmetric where its parameters are.
Seedling bare_seedling() {
  TreeParameters parameters = small_tree();
  parameters.stem_length = 0.0;
  parameters.iterations = 12;
  return make_seedling(parameters);
}

TEST(GrowthLaw, MirroredPointsGrowTheMirroredTree) {
  const auto mirrored = [](auto points) {
    for (Vector3& point : points) point.x = -point.x;
    return points;
  };
  Seedling seedling = bare_seedling();
  const Skeleton tree = grow(seedling).skeleton;
  ASSERT_GT(tree.edge_count(), 50u);
  seedling.attraction_points = mirrored(seedling.attraction_points);
  const Skeleton mirror_tree = grow(seedling).skeleton;
  EXPECT_EQ(mirror_tree.parents(), tree.parents());
  EXPECT_EQ(mirror_tree.positions(), mirrored(tree.positions()));
}

TEST(GrowthLaw, DoubledLengthsGrowTheDoubledTree) {
  const auto doubled = [](auto points) {
    for (Vector3& point : points) point = 2.0 * point;
    return points;
  };
  Seedling seedling = bare_seedling();
  const Skeleton tree = grow(seedling).skeleton;
  ASSERT_GT(tree.edge_count(), 50u);
  seedling.attraction_points = doubled(seedling.attraction_points);
  seedling.growth.step_length *= 2.0;
  seedling.growth.influence_distance *= 2.0;
  seedling.growth.kill_distance.begin *= 2.0;
  seedling.growth.kill_distance.end *= 2.0;
  const Skeleton double_tree = grow(seedling).skeleton;
  EXPECT_EQ(double_tree.parents(), tree.parents());
  EXPECT_EQ(double_tree.positions(), doubled(tree.positions()));
}

}  // namespace
}  // namespace phytobench
