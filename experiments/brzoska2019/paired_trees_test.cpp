// SPDX-License-Identifier: MIT
#include "experiments/brzoska2019/paired_trees.hpp"

#include <set>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench::experiments::brzoska2019 {
namespace {

ExperimentContext context_with_seed(std::uint64_t seed) {
  return {"brzoska2019/test", Tier::smoke, seed, 1};
}

RecordValue value_of(const ExperimentContext& context, const std::string& name) {
  for (const Record& record : context.records())
    if (record.measurement == "brzoska2019/test/" + name) return record.value;
  return std::string("missing");
}

TEST(PairedTrees, RunsOfOtherSeedsHaveOtherTrees) {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t run : {0u, 1u, 2u})
    for (std::size_t number = 0; number < trees_per_trend; ++number)
      seeds.insert(tree_of_trend({}, context_with_seed(run), number).seed);
  EXPECT_EQ(seeds.size(), 3 * trees_per_trend);
  EXPECT_THROW(tree_of_trend({}, context_with_seed(0), 1000), ContractViolation);
}

TEST(PairedTrees, SettingsButTheSeedStay) {
  TreeParameters parameters;
  parameters.influence_distance = 0.77;
  const TreeParameters tree = tree_of_trend(parameters, context_with_seed(0), 3);
  EXPECT_EQ(tree.influence_distance, 0.77);
  EXPECT_EQ(tree.random, StreamKind::counter);
}

TEST(PairedTrees, TreesThatStopEarlyAreLeftOut) {
  TreeParameters parameters;
  parameters.cloud_density = 12.0;  // so few points that some trees find none
  parameters.iterations = 8;
  const ExperimentContext context = context_with_seed(0);
  FullTrees trees(parameters, context);
  for (int i = 0; i < 20; ++i) {
    const GrownTree tree = trees.next();
    EXPECT_GE(tree.skeleton.node_count(), tree.seedling.skeleton.node_count() + 8)
        << "a node at least in every iteration";
  }
  EXPECT_GT(trees.left_out(), 0);
}

TEST(PairedTrees, RecordsHaveTheSeedOfTheTreeThatWasMeasured) {
  TreeParameters parameters;
  parameters.cloud_density = 12.0;  // as above
  parameters.iterations = 8;
  ExperimentContext context = context_with_seed(0);
  FullTrees trees(parameters, context);
  constexpr std::size_t number_of_trees = 20;
  record_trees(
      context, "nodes", "nodes",
      [&](std::size_t) { return static_cast<double>(trees.next().skeleton.node_count()); },
      number_of_trees, [&](std::size_t number) { return trees.seed(number); });
  ASSERT_GT(trees.left_out(), 0);
  EXPECT_THROW(trees.seed(number_of_trees), ContractViolation);
  TreeParameters again = tree_of_trend(parameters, context, 0);
  for (std::size_t number = 0; number < number_of_trees; ++number) {
    const Record& record = context.records().at(number);
    again.seed = record.seed.value();
    const GrowthResult result = grow_seedling(make_seedling(again), context);
    EXPECT_EQ(record.value, RecordValue(static_cast<double>(result.skeleton.node_count())));
  }
}

TEST(PairedTrees, TreesThatNeverGrowAreAMistake) {
  TreeParameters parameters;
  parameters.cloud_density = 0.1;
  const ExperimentContext context = context_with_seed(0);
  EXPECT_THROW(FullTrees(parameters, context).next(), ContractViolation);
}

TEST(PairedTrees, ATrendCountsTheTreesThatFollowIt) {
  ExperimentContext context = context_with_seed(0);
  const ByTree rising =
      record_trees(context, "a", "1", [](std::size_t i) { return static_cast<double>(i); });
  const ByTree constant = record_trees(context, "b", "1", [](std::size_t) { return 5.0; });
  EXPECT_EQ(value_of(context, "a/tree-07"), RecordValue(7.0));
  EXPECT_EQ(value_of(context, "a/mean"), RecordValue(9.5));
  record_falling(context, "fall", {"x", "y", "z"}, {rising, constant, constant});
  EXPECT_EQ(value_of(context, "fall/x-to-y/wins"), RecordValue(std::int64_t{14})) << "6 to 19";
  EXPECT_EQ(value_of(context, "fall/y-to-z/wins"), RecordValue(std::int64_t{0})) << "equal is less";
  EXPECT_THROW(record_falling(context, "fall", {"x"}, {rising, constant}), ContractViolation);
}

}  // namespace
}  // namespace phytobench::experiments::brzoska2019
