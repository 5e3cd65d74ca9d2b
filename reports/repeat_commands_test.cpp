// SPDX-License-Identifier: MIT
#include "reports/repeat_commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SelectionOf, KeepsIdsAndQuotesGlobs) {
  EXPECT_THAT(selection_of("phytobench run p/a q/* --tier smoke --out results/x --resume r/b"),
              ElementsAre("p/a", "'q/*'", "r/b"));
  EXPECT_THAT(selection_of("phytobench run --tier=full --out=a/b --seed 3 --threads 2 p/a"),
              ElementsAre("p/a"));
}

TEST(SelectionOf, IsEmptyForAWholeRunAndOtherCommands) {
  EXPECT_THAT(selection_of("phytobench run --tier quick --out results/x"), IsEmpty());
  EXPECT_THAT(selection_of("phytobench race p/a"), IsEmpty());
  EXPECT_THAT(selection_of("phytobench"), IsEmpty());
  EXPECT_THAT(selection_of(""), IsEmpty());
  EXPECT_THAT(selection_of("phytobench run --out"), IsEmpty());
}

TEST(SelectionOf, TakesNoPartOfAPathWithSpaces) {
  EXPECT_THAT(selection_of("phytobench run p/a --out my results"), ElementsAre("p/a"));
}

TEST(RepeatRun, NamesTheSelection) {
  EXPECT_EQ(repeat_run({"'p/*'"}, Tier::smoke, 7),
            "phytobench run 'p/*' --tier smoke --seed 7 --out results/again");
  EXPECT_EQ(repeat_run({}, Tier::quick, 0),
            "phytobench run --tier quick --seed 0 --out results/again");
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
