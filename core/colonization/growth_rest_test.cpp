// SPDX-License-Identifier: MIT
// Nodes that rest ([Liebemann2017] sec. 3.5, max_NG), and that no engine, loop option or number of
// threads matters to any of the limits.
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/colonization/test_discs.hpp"
#include "core/colonization/test_growth.hpp"
#include "core/colonization/tree_parameters.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

Seedling resting_disc(std::uint64_t seed, std::int32_t rest_iterations) {
  Seedling seedling = disc_scene(seed);
  seedling.growth.limits.rest_iterations = rest_iterations;
  return seedling;
}

// Two points that the nodes between them cannot come near to ([Liebemann2017] sec. 5.3), and a
// branch that grows past them, always a little farther from the right one than those nodes are.
TEST(RestingNode, GivesItsPointsToTheNextNearest) {
  const Vector3 left{-40, 0, 0}, right{40, 0, 0};
  Seedling seedling =
      flat_scene({left, right, {90, 0, 0}, {90, 60, 0}, {90, 120, 0}}, {0, -50, 0}, 100);
  seedling.skeleton.append(0, {90, -50, 0});
  EXPECT_EQ(grow(seedling).live_points, 2u);
  seedling.growth.limits.rest_iterations = 2;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(result.stop_reason, StopReason::no_points_left);
}

TEST(RestingNode, IsNotSearchedAnyMore) {
  const GrowthResult result = grow(resting_disc(1, 1));
  std::size_t fewest = result.passes.back().searchable_nodes;
  for (const PassStatistics& pass : result.passes) {
    ASSERT_EQ(pass.search_evaluations, pass.queried_points * pass.searchable_nodes);
    fewest = std::min(fewest, pass.searchable_nodes);
  }
  EXPECT_LT(fewest, result.skeleton.node_count() / 4);
}

// One point ahead: only the newest node grows, so all others rest at once.
TEST(RestingNode, IsEveryNodeBehindTheTipOfALonelyBranch) {
  Seedling seedling = flat_scene({{0, 99, 0}}, {}, 50);
  const GrowthResult without = grow(seedling);
  seedling.growth.limits.rest_iterations = 1;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(tree_hash(result.skeleton), tree_hash(without.skeleton));
  for (const PassStatistics& pass : result.passes) EXPECT_LE(pass.searchable_nodes, 2u);
}

// [Liebemann2017] says that a careful choice leaves the tree as it is and spares comparisons.
TEST(RestingNodeLaw, LongPatienceChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const GrowthResult without = grow(disc_scene(seed));
    ASSERT_LT(without.passes.size(), 200u);
    const GrowthResult result = grow(resting_disc(seed, 100000));
    EXPECT_EQ(tree_hash(result.skeleton), tree_hash(without.skeleton));
    // While something could still come to rest growth goes on, to the last iteration.
    EXPECT_EQ(result.stop_reason, without.stop_reason == StopReason::no_new_node
                                      ? StopReason::iteration_limit
                                      : without.stop_reason);
    for (std::size_t i = 0; i < without.passes.size(); ++i)
      ASSERT_EQ(result.passes[i].search_evaluations, without.passes[i].search_evaluations);
  }
}

TEST(RestingNodeLaw, ShorterPatienceComparesLess) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::size_t iterations = grow(disc_scene(seed)).passes.size();
    double last = 0.0;
    for (const std::int32_t rest : {1, 2, 3, 5, 10, 20}) {
      Seedling seedling = resting_disc(seed, rest);
      seedling.growth.iterations = static_cast<int>(iterations);
      const auto now = static_cast<double>(grow(seedling).work.search_evaluations);
      EXPECT_GT(now, last) << "seed " << seed << ", rest after " << rest;
      last = now;
    }
  }
}

/// Every setting that this file and its neighbour are about.
std::map<std::string, Seedling> limited_discs() {
  std::map<std::string, Seedling> scenes;
  const auto add = [&](const char* name, const GrowthLimits& limits) {
    scenes.emplace(name, disc_scene(7, 100)).first->second.growth.limits = limits;
  };
  add("most_children", {.most_children = 2});
  add("most_branch_depth", {.most_branch_depth = 1});
  add("rest_1", {.rest_iterations = 1});
  add("rest_4", {.rest_iterations = 4});
  add("weighted", {.most_branch_depth = 3, .step_weighting = StepWeighting::by_branch_depth});
  add("all", {.most_children = 2,
              .most_branch_depth = 3,
              .rest_iterations = 2,
              .step_weighting = StepWeighting::by_branch_depth});
  scenes.emplace("plain", disc_scene(7, 100));
  Seedling exclusive = disc_scene(7, 100);
  exclusive.growth.variant.influence_boundary = Boundary::exclusive;
  exclusive.growth.variant.kill_boundary = Boundary::exclusive;
  scenes.emplace("exclusive", exclusive);
  // A cone of perception, tested after the search as well, and repeats.
  for (const auto& [name, scene] : std::map(scenes)) {
    Seedling narrow = scene;
    narrow.growth.perception_angle_rad = 2.5;
    narrow.growth.tropism = {0, 0.3, 0};
    scenes.emplace(name + "_narrow", narrow);
    narrow.growth.variant.perception_test = PerceptionTest::after_search;
    scenes.emplace(name + "_after_search", narrow);
    Seedling repeating = scene;
    repeating.growth.variant.repeat_guard = RepeatGuard::off;
    repeating.growth.iterations = 40;
    scenes.emplace(name + "_repeating", repeating);
  }
  return scenes;
}

TEST(GrowthLimitsLaw, EveryEngineGrowsTheSameTree) {
  for (const auto& [name, seedling] : limited_discs()) {
    const GrowthResult expected = grow(seedling);
    for (const EngineDescriptor* engine : all_engines()) {
      if (!engine->built()) continue;
      const GrowthResult result = grow(seedling, {}, engine->name);
      ASSERT_EQ(tree_hash(result.skeleton), tree_hash(expected.skeleton))
          << name << ", " << engine->name;
      ASSERT_EQ(result.stop_reason, expected.stop_reason) << name << ", " << engine->name;
    }
  }
}

TEST(GrowthLimitsLaw, LoopOptionsAndThreadsGrowTheSameTree) {
  for (const auto& [name, seedling] : limited_discs()) {
    const std::string expected = tree_hash(grow(seedling).skeleton);
    for (const std::string_view option : loop_option_names)
      for (const int threads : {1, 3})
        for (const char* engine : {"squared_scan", "node_driven"})
          ASSERT_EQ(
              tree_hash(grow(seedling, {.options = loop_options_named(option), .threads = threads},
                             engine)
                            .skeleton),
              expected)
              << name << ", " << option << ", " << threads << " threads, " << engine;
  }
}

// Otherwise the two tests above could compare trees that no limit has touched.
TEST(GrowthLimitsLaw, EachLimitGrowsAnotherTree) {
  const auto scenes = limited_discs();
  std::map<std::string, std::string> of_hash;
  for (const char* name :
       {"plain", "most_children", "most_branch_depth", "rest_1", "rest_4", "weighted", "all"}) {
    const std::string hash = tree_hash(grow(scenes.at(name)).skeleton);
    EXPECT_TRUE(of_hash.emplace(hash, name).second) << name << " and " << of_hash[hash];
  }
}

// The limits' own code, with nothing to forbid: not a bit differs from the tree without them.
TEST(GrowthLimitsLaw, LimitsThatNobodyReachesChangeNoBit) {
  TreeParameters parameters;
  parameters.cloud.radii = {2.0, 2.8, 1.8};
  const Seedling seedling = make_seedling(parameters);
  Seedling limited = seedling;
  limited.growth.limits = {.most_children = 1000, .most_branch_depth = 1000};
  EXPECT_EQ(tree_hash(grow(limited).skeleton), tree_hash(grow(seedling).skeleton));
  limited.growth.limits.rest_iterations = 1000;
  EXPECT_EQ(tree_hash(grow(limited).skeleton), tree_hash(grow(seedling).skeleton));
}

}  // namespace
}  // namespace phytobench
