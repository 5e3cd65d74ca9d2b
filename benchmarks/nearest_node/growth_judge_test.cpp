// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/growth_judge.hpp"
#include "benchmarks/nearest_node/awkward_seedlings.hpp"

#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/nearest_node/engine_fixture.hpp"
#include "benchmarks/nearest_node/growth_trace.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

std::vector<NamedSeedling> judged_seedlings() {
  std::vector<NamedSeedling> all;
  all.push_back({"random", with_crown_stem(seedling_with(random_cube(900), 0.5, 0.3, 15))});
  all.push_back({"lattice", with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10))});
  all.push_back({"infinite", seedling_with(random_cube(300), infinite_length, 0.3, 10)});
  all.push_back({"one_point", seedling_with({{0.0, 0.5, 0.0}}, 0.5, 0.25, 5)});
  all.push_back({"no_point", seedling_with({}, 0.5, 0.25, 5)});
  all.push_back({"test_tree", scaled_test_tree({.points = 3000.0}).seedling});
  return all;
}

/// How many points the plain loop looks at: none, a few, more than there are.
constexpr std::size_t sample_sizes[] = {0, 1, 50, 2999, 1'000'000, no_limit};

TEST(GridJudge, VerifiesRightEnginesWithEveryLoopOption) {
  const Seedling seedling = scaled_test_tree({.points = 3000.0}).seedling;
  const GrowthOracle oracle(seedling);
  const auto judge = make_grid_judge(seedling, 1);
  for (const char* engine : {"squared_scan", "node_driven"})
    for (const std::string_view option : loop_option_names)
      for (const int threads : {1, 2}) {
        const CheckedGrowth checked =
            grow_checked(engine_named(engine), seedling, *judge,
                         {.options = loop_options_named(option), .threads = threads});
        ASSERT_TRUE(checked.verified.has_value())
            << engine << ", option " << option << ", " << threads
            << " threads: " << checked.disagreement;
        EXPECT_EQ(checked.verified->hash(), oracle.hash()) << engine << ", option " << option;
        EXPECT_GT(checked.result.skeleton.edge_count(), 100u);
      }
}

TEST(GridJudge, VerifiesWhateverTheSizeAndSeedOfItsSample) {
  for (const NamedSeedling& tried : judged_seedlings())
    for (const std::size_t sampled : sample_sizes)
      for (const std::uint64_t seed : {0u, 7u}) {
        const auto judge = make_grid_judge(tried.seedling, seed, sampled);
        const CheckedGrowth checked =
            grow_checked(engine_named("node_driven"), tried.seedling, *judge, {});
        EXPECT_TRUE(checked.verified.has_value())
            << tried.name << ", " << sampled << " sampled: " << checked.disagreement;
      }
}

TEST(GridJudge, RefusesEveryWrongEngineWhateverTheSizeOfItsSample) {
  int wrong_engines = 0;
  for (const EngineDescriptor* engine : all_engines()) {
    if (!is_wrong_on_purpose(*engine)) continue;
    ++wrong_engines;
    for (const std::size_t sampled : sample_sizes) {
      bool refused = false;
      for (const NamedSeedling& tried : judged_seedlings()) {
        const auto judge = make_grid_judge(tried.seedling, 1, sampled);
        const CheckedGrowth checked = grow_checked(*engine, tried.seedling, *judge, {});
        EXPECT_EQ(checked.verified.has_value(), checked.disagreement.empty());
        refused |= !checked.verified.has_value();
      }
      EXPECT_TRUE(refused) << engine->name << " passed every workload, " << sampled << " sampled";
    }
  }
  EXPECT_EQ(wrong_engines, 4) << "faulty_engines.def did not reach the registry";
}

// Both judges stop a wrong engine at the same answer, with the same words.
TEST(GridJudge, RefusesAtTheSameAnswerAsTheLiteralJudge) {
  const Seedling seedling = with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
  const GrowthOracle oracle(seedling);
  const auto judge = make_grid_judge(seedling, 1);
  for (const EngineDescriptor* engine : all_engines()) {
    if (!is_wrong_on_purpose(*engine)) continue;
    const CheckedGrowth literal = grow_checked(*engine, seedling, oracle, {});
    const CheckedGrowth grid = grow_checked(*engine, seedling, *judge, {});
    EXPECT_EQ(grid.disagreement, literal.disagreement) << engine->name;
  }
}

TEST(GridJudge, JudgesARightEngineAfterAWrongOne) {
  const Seedling seedling = with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
  const auto judge = make_grid_judge(seedling, 1);
  for (int round = 0; round < 2; ++round) {
    EXPECT_FALSE(grow_checked(engine_named("breaks_ties_upwards"), seedling, *judge, {}).verified);
    const CheckedGrowth checked = grow_checked(engine_named("squared_scan"), seedling, *judge, {});
    EXPECT_TRUE(checked.verified.has_value()) << checked.disagreement;
  }
}

TEST(GridJudge, FollowsASearchThatTestsTheAngleAfterwards) {
  Seedling seedling = scaled_test_tree({.points = 3000.0}).seedling;
  const auto before = grow_checked(engine_named("squared_scan"), seedling,
                                   *make_grid_judge(seedling, 1, no_limit), {});
  seedling.growth.variant.perception_test = PerceptionTest::after_search;
  const auto after = grow_checked(engine_named("squared_scan"), seedling,
                                  *make_grid_judge(seedling, 1, no_limit), {});
  ASSERT_TRUE(before.verified.has_value()) << before.disagreement;
  ASSERT_TRUE(after.verified.has_value()) << after.disagreement;
  EXPECT_NE(before.verified->hash(), after.verified->hash()) << "the variant changes nothing";
}

TEST(GridJudge, DoesNotKnowTheTreeBeforehand) {
  const Seedling seedling = seedling_with(random_cube(50), 0.5, 0.3, 5);
  const auto judge = make_grid_judge(seedling, 1);
  EXPECT_TRUE(judge->tree_hash().empty());
  EXPECT_THAT(judge->name(), HasSubstr("grid oracle"));
}

TEST(LiteralJudge, KnowsTheTreeBeforehand) {
  const Seedling seedling = with_crown_stem(seedling_with(random_cube(400), 0.5, 0.3, 8));
  const GrowthOracle oracle(seedling);
  const auto judge = make_literal_judge(oracle);
  const auto engine = engine_named("squared_scan").create();
  EXPECT_EQ(judge->tree_hash(), oracle.hash());
  EXPECT_EQ(judge->tree_hash(), tree_hash(grow_crown(seedling, *engine).skeleton));
  EXPECT_THAT(judge->name(), HasSubstr("literal oracle"));
}

TEST(LiteralJudge, ExpectsNoCallBeyondTheLast) {
  const Seedling seedling = seedling_with(random_cube(400), 0.5, 0.3, 8);
  const GrowthOracle oracle(seedling);
  const auto judge = make_literal_judge(oracle);
  for (int round = 0; round < 2; ++round) {
    judge->restart();
    bool expected = false;
    for (std::size_t i = 0; i < oracle.tree().passes.size(); ++i)
      EXPECT_EQ(judge->associate({}).size(), 400u) << "round " << round << ", call " << i;
    EXPECT_TRUE(judge->associate({}).empty());
    for (std::size_t i = 0; i < oracle.tree().removals.size(); ++i) {
      judge->remove({}, 0.3, expected);
      EXPECT_TRUE(expected) << "round " << round << ", call " << i;
    }
    judge->remove({}, 0.3, expected);
    EXPECT_FALSE(expected);
  }
}

// The two judges know nothing of each other: one has grown the tree itself, the other is told.
TEST(GrowthJudgeOracle, BothGiveTheSameAnswerToEveryCall) {
  for (const NamedSeedling& tried : judged_seedlings()) {
    const GrowthOracle oracle(tried.seedling);
    const auto literal = make_literal_judge(oracle);
    const auto grid = make_grid_judge(tried.seedling, 3, no_limit);
    const GrowthTrace trace = record_trace(engine_named("squared_scan"), tried.seedling, {});
    literal->restart();
    grid->restart();
    for (const GrowthTrace::Step& step : trace.steps) {
      if (step.is_kill) {
        bool literal_expects = false, grid_expects = false;
        const auto truth = literal->remove(step.nodes, step.kill_distance, literal_expects);
        EXPECT_EQ(grid->remove(step.nodes, step.kill_distance, grid_expects), truth) << tried.name;
        EXPECT_TRUE(literal_expects) << tried.name;
        EXPECT_TRUE(grid_expects) << tried.name;
      } else {
        const std::span<const int> truth = literal->associate(step.nodes);
        const std::span<const int> answer = grid->associate(step.nodes);
        ASSERT_EQ(std::vector<int>(answer.begin(), answer.end()),
                  std::vector<int>(truth.begin(), truth.end()))
            << tried.name;
      }
    }
  }
}

// By hand: two nodes equally near to a point, and one nearer that does not perceive it.
TEST(GrowthJudgeOracle, GridGivesTiesToTheLowestNodeAndHeedsTheAngle) {
  Seedling seedling = seedling_with({{0, 0.5, 0}, {0, 5, 0}}, 1.0, 0.25, 5);
  const Vector3 up{0, 1, 0};
  const std::vector<SearchableNode> nodes{{{0, 0.6, 0}, up}, {{0.4, 0, 0}, up}, {{-0.4, 0, 0}, up}};
  const auto judge = make_grid_judge(seedling, 0, no_limit);
  judge->restart();
  const std::span<const int> answer = judge->associate(nodes);
  EXPECT_EQ(std::vector<int>(answer.begin(), answer.end()), (std::vector<int>{1, -1}));
  bool expected = false;
  EXPECT_EQ(judge->remove(nodes, 0.05, expected), std::vector<int>{});
  EXPECT_EQ(judge->remove(nodes, 0.15, expected), std::vector<int>{0}) << "whatever the angle";
  EXPECT_EQ(judge->associate({})[0], -1) << "a removed point has no node";
}

}  // namespace
}  // namespace phytobench
