// SPDX-License-Identifier: MIT
#include "reports/document_costs.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

struct CostlyRun {
  RunContents run;
  std::map<std::string, ExperimentFacts> facts;

  CostlyRun() {
    run.header = {Tier::quick, 0};
    run.timings = {
        {.experiment = "b/x", .measurement = "b/x/cost/seconds", .value = 120.0},
        {.experiment = "b/x", .measurement = "b/x/cost/peak_memory", .value = 45.2, .unit = "MiB"},
        {.experiment = "b/x", .measurement = "b/x/seconds", .value = 7.0}};
    facts["b/x"] = {"Does it?", "[B] eq. 1", {1.0, 100.0, 1000.0}};
    facts["b/y"] = {"Does that?", "[B] eq. 2", {0.1, 60.0, 600.0}};
  }
};

TEST(ExperimentCosts, AreTheMeasuredOnesOfThisTier) {
  const CostlyRun costly;
  const ExperimentCosts costs(costly.run, costly.facts, false);
  const CostOfRepeat cost = costs.of({"b/x"}, Tier::quick);
  EXPECT_EQ(cost.time, "2 min");
  EXPECT_EQ(cost.memory, "45 MiB");
  EXPECT_TRUE(cost.varies);
  EXPECT_EQ(costs.measured_seconds(), 120.0);
}

TEST(ExperimentCosts, AreTheExpectedOnesOtherwise) {
  const CostlyRun costly;
  const ExperimentCosts costs(costly.run, costly.facts, false);
  EXPECT_EQ(costs.of({"b/x"}, Tier::full).time, "17 min");
  EXPECT_EQ(costs.of({"b/x"}, Tier::full).memory, "");
  EXPECT_FALSE(costs.of({"b/x"}, Tier::full).varies);
  EXPECT_EQ(costs.of({"b/x", "b/y"}, Tier::quick).time, "3 min");
}

TEST(ExperimentCosts, DoNotVaryWhereNothingMay) {
  const CostlyRun costly;
  const CostOfRepeat cost =
      ExperimentCosts(costly.run, costly.facts, true).of({"b/x"}, Tier::quick);
  EXPECT_EQ(cost.time, "2 min");
  EXPECT_EQ(cost.memory, "");
  EXPECT_FALSE(cost.varies);
}

TEST(ExperimentCosts, AreEmptyForTheUnknown) {
  const CostlyRun costly;
  const ExperimentCosts costs(costly.run, {}, false);
  EXPECT_EQ(costs.of({"b/y"}, Tier::quick).time, "");
  EXPECT_EQ(costs.of({}, Tier::quick).time, "");
}

TEST(ExperimentCosts, AreToldApartFromOtherTimes) {
  const CostlyRun costly;
  EXPECT_TRUE(is_cost(costly.run.timings[0]));
  EXPECT_FALSE(is_cost(costly.run.timings[2]));
}

}  // namespace
}  // namespace phytobench
