// SPDX-License-Identifier: MIT
#include "reports/repeat_commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RepeatRun, NamesTheExperiments) {
  EXPECT_EQ(repeat_run({"p/a", "p/b"}, {Tier::smoke, 7}, "results/again"),
            "phytobench run p/a p/b --tier smoke --seed 7 --out results/again");
  EXPECT_EQ(repeat_run({}, {Tier::quick, 0}, "results/again-2"),
            "phytobench run --tier quick --seed 0 --out results/again-2");
}

TEST(RepeatExperiments, HasAFolderForEachExperimentAndTier) {
  EXPECT_EQ(repeat_experiments({"p/a-b"}, Tier::smoke),
            "phytobench run p/a-b --tier smoke --out results/again-p-a-b-smoke");
  EXPECT_EQ(repeat_experiments({"p/a", "p/b"}, Tier::full),
            "phytobench run p/a p/b --tier full --out results/again-p-a-and-p-b-full");
}

TEST(RepeatExperiments, NamesAnUnusualSeed) {
  EXPECT_EQ(repeat_experiments({"p/a"}, Tier::smoke, 7),
            "phytobench run p/a --tier smoke --seed 7 --out results/again-p-a-smoke-7");
}

TEST(ExperimentsOf, NamesEachOnceWithoutTheSignsOfASum) {
  Claim claim;
  claim.checks = {{.subject = CheckSubject::sum, .terms = {{"+p/b/x/y", "-p/a/x"}}},
                  {.terms = {{"p/b/z"}, {"p/c/z"}}}};
  EXPECT_THAT(experiments_of(claim), ElementsAre("p/b", "p/a", "p/c"));
  EXPECT_THAT(experiments_of(Claim{}), IsEmpty());
}

}  // namespace
}  // namespace phytobench
