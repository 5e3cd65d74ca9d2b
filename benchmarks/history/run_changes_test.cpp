// SPDX-License-Identifier: MIT
#include "benchmarks/history/run_changes.hpp"

#include <cmath>

#include "benchmarks/history/history_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(RunChanges, CountsAreComparedExactly) {
  const HistoryChanges changes = changes_between(
      history_run_of("a"),
      {counter_of("p", 1000), counter_of("q", 5), counter_of("zero", 0), counter_of("gone", 1)},
      history_run_of("b"),
      {counter_of("zero", 2), counter_of("q", 5), counter_of("p", 1001), instructions_of("p", 3),
       counter_of("new", 1)});
  ASSERT_EQ(changes.values.size(), 3u);
  EXPECT_FALSE(changes.values[0].is_equal());
  EXPECT_NEAR(changes.values[0].relative(), 0.001, 1e-12);
  EXPECT_TRUE(changes.values[1].is_equal());
  EXPECT_EQ(changes.values[1].relative(), 0.0);
  EXPECT_TRUE(std::isinf(changes.values[2].relative()));
  EXPECT_EQ(changes.only_before, 1u);
  EXPECT_EQ(changes.only_after, 2u);
  EXPECT_EQ(changes.caution, "");
}

TEST(RunChanges, RatiosOfDifferentMachinesAreLeftOut) {
  const std::vector<HistoryValue> before = {HistoryValue::ratio("p", "i", 2.0)};
  const std::vector<HistoryValue> after = {HistoryValue::ratio("p", "i", 3.0)};
  const HistoryChanges apart =
      changes_between(history_run_of("a"), before, history_run_of("b", "Model 2"), after);
  EXPECT_TRUE(apart.values.empty());
  EXPECT_EQ(apart.ratios_left_out, 1u);
  const HistoryChanges alike =
      changes_between(history_run_of("a"), before, history_run_of("b"), after);
  ASSERT_EQ(alike.values.size(), 1u);
  EXPECT_DOUBLE_EQ(alike.values[0].relative(), 0.5);
}

TEST(RunChanges, OtherInputsAndMachinesAreSaid) {
  const HistoryChanges inputs =
      changes_between(history_run_of("a"), {instructions_of("p", 1, "i")}, history_run_of("b"),
                      {instructions_of("p", 1, "j")});
  EXPECT_FALSE(inputs.values.at(0).has_same_inputs);
  EXPECT_THAT(changes_between(history_run_of("a"), {instructions_of("p", 1)},
                              history_run_of("b", "Model 2"), {instructions_of("p", 1)})
                  .caution,
              HasSubstr("different machines"));
  EXPECT_EQ(changes_between(history_run_of("a"), {counter_of("p", 1)},
                            history_run_of("b", "Model 2"), {counter_of("p", 1)})
                .caution,
            "");
}

}  // namespace
}  // namespace phytobench
