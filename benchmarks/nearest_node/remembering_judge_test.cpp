// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/remembering_judge.hpp"

#include <gtest/gtest.h>

#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/nearest_node/growth_trace.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

/// Passes on to the grid oracle and counts what it is asked.
class CountingJudge final : public GrowthJudge {
 public:
  CountingJudge(const Seedling& seedling, int& calls, int& restarts)
      : judge_(make_grid_judge(seedling, 1)), calls_(calls), restarts_(restarts) {}

  void restart() override {
    ++restarts_;
    judge_->restart();
  }
  std::span<const int> associate(std::span<const SearchableNode> new_nodes) override {
    ++calls_;
    return judge_->associate(new_nodes);
  }
  std::vector<int> remove(std::span<const SearchableNode> killers, double distance,
                          bool& expected) override {
    ++calls_;
    return judge_->remove(killers, distance, expected);
  }
  std::string tree_hash() const override { return judge_->tree_hash(); }
  std::string name() const override { return judge_->name(); }

 private:
  std::unique_ptr<GrowthJudge> judge_;
  int& calls_;
  int& restarts_;
};

class RememberingJudgeTest : public testing::Test {
 protected:
  const Seedling seedling_ = scaled_test_tree({.points = 3000.0}).seedling;
  const GrowthTrace trace_ = record_trace(engine_named("squared_scan"), seedling_, {});
  int calls_ = 0, restarts_ = 0;
  const std::unique_ptr<GrowthJudge> judge_ =
      make_remembering_judge(std::make_unique<CountingJudge>(seedling_, calls_, restarts_));

  /// Asks for the first `steps` of the trace, with the kill distance of step `other` halved, and
  /// expects the answers of a judge that remembers nothing.
  void expect_right_answers(std::size_t steps, std::size_t other = no_other) {
    const auto plain = make_grid_judge(seedling_, 1);
    plain->restart();
    judge_->restart();
    for (std::size_t i = 0; i < steps; ++i) {
      const GrowthTrace::Step& step = trace_.steps[i];
      if (step.is_kill) {
        const double distance = step.kill_distance * (i == other ? 0.5 : 1.0);
        bool expected = false;
        const std::vector<int> truth = plain->remove(step.nodes, distance, expected);
        EXPECT_EQ(judge_->remove(step.nodes, distance, expected), truth) << "step " << i;
        EXPECT_TRUE(expected);
      } else {
        const std::span<const int> truth = plain->associate(step.nodes);
        EXPECT_TRUE(std::ranges::equal(judge_->associate(step.nodes), truth)) << "step " << i;
      }
    }
  }

  std::size_t last_kill_before(std::size_t step) const {
    while (!trace_.steps[--step].is_kill) {
    }
    return step;
  }

  static constexpr std::size_t no_other = static_cast<std::size_t>(-1);
};

TEST_F(RememberingJudgeTest, AsksEverySameQuestionOnce) {
  const std::size_t steps = trace_.steps.size();
  ASSERT_GT(steps, 20u);
  for (int growth = 0; growth < 3; ++growth) expect_right_answers(steps);
  EXPECT_EQ(calls_, static_cast<int>(steps));
  EXPECT_EQ(restarts_, 1);
}

TEST_F(RememberingJudgeTest, GoesOnWhereAGrowthWasStopped) {
  const std::size_t steps = trace_.steps.size();
  for (const std::size_t until : {std::size_t{0}, std::size_t{1}, steps / 2, steps / 3, steps})
    expect_right_answers(until);
  EXPECT_EQ(calls_, static_cast<int>(steps));
  EXPECT_EQ(restarts_, 1);
}

TEST_F(RememberingJudgeTest, AnswersOtherQuestionsAnew) {
  const std::size_t steps = trace_.steps.size(), kill = last_kill_before(steps / 2);
  expect_right_answers(steps / 2 + 1);
  expect_right_answers(steps, kill);
  const int after_other = calls_;
  EXPECT_GE(after_other, static_cast<int>(steps / 2 + 1 + steps)) << "something was not asked";
  expect_right_answers(steps);  // the memory is of the first growth still, and goes on with it
  EXPECT_EQ(calls_, after_other + static_cast<int>(steps));
  expect_right_answers(steps);
  EXPECT_EQ(calls_, after_other + static_cast<int>(steps));
}

TEST_F(RememberingJudgeTest, TellsOtherNodesFromThoseRemembered) {
  expect_right_answers(trace_.steps.size());
  std::vector<SearchableNode> turned(trace_.steps[0].nodes.begin(), trace_.steps[0].nodes.end());
  turned.back().direction = -1.0 * turned.back().direction;
  const auto plain = make_grid_judge(seedling_, 1);
  plain->restart();
  judge_->restart();
  const std::span<const int> truth = plain->associate(turned);
  EXPECT_TRUE(std::ranges::equal(judge_->associate(turned), truth));
}

TEST(RememberingJudge, RefusesWrongEnginesAtTheSameAnswer) {
  const Seedling seedling = with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
  const auto plain = make_grid_judge(seedling, 1);
  const auto judge = make_remembering_judge(make_grid_judge(seedling, 1));
  int refused = 0;
  for (int round = 0; round < 2; ++round)
    for (const EngineDescriptor* engine : all_engines()) {
      if (!engine->built()) continue;
      const CheckedGrowth expected = grow_checked(*engine, seedling, *plain, {});
      const CheckedGrowth checked = grow_checked(*engine, seedling, *judge, {});
      EXPECT_EQ(checked.verified.has_value(), expected.verified.has_value()) << engine->name;
      EXPECT_EQ(checked.disagreement, expected.disagreement) << engine->name;
      refused += !checked.verified.has_value();
    }
  EXPECT_GE(refused, 4) << "no wrong engine was tried";
}

}  // namespace
}  // namespace phytobench
