// SPDX-License-Identifier: MIT
#include "reports/run_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/latex_claims.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Claims on two experiments at tier smoke and one at tier full.
struct ThreeExperiments {
  std::vector<Claim> claims;
  JudgedRun judged;

  ThreeExperiments() : claims(3) {
    const char* const names[] = {"b/x", "b/y", "b/z"};
    for (std::size_t i = 0; i < claims.size(); ++i)
      claims[i].checks = {{.terms = {{std::string(names[i]) + "/a"}}}};
    claims[2].tier = Tier::full;
    judged.run.header = {Tier::smoke, 0};
    judged.run.complete_experiments = {"b/x", "b/y"};
    judged.papers.resize(1);
    for (const Claim& claim : claims)
      judged.papers[0].judgements.push_back({.claim = &claim, .verdict = Verdict::reproduced});
  }
};

TEST(Incompleteness, IsNothingOfAWholeRun) {
  EXPECT_EQ(incompleteness(ThreeExperiments().judged), "");
}

TEST(Incompleteness, NamesTheExperimentThatBreaksOff) {
  ThreeExperiments of;
  of.judged.run.complete_experiments.erase("b/y");
  of.judged.run.unfinished = "b/y";
  const std::string text = incompleteness(of.judged);
  EXPECT_THAT(text, HasSubstr("The records of b/y break off"));
  EXPECT_THAT(text, Not(HasSubstr("not in it"))) << "it is told once";
}

TEST(Incompleteness, NamesExperimentsThatClaimsOfTheTierRestOn) {
  ThreeExperiments of;
  of.judged.run.complete_experiments.erase("b/y");
  EXPECT_EQ(incompleteness(of.judged),
            "This run is not whole. 1 of the 2 experiments that claims of tier smoke rest on is "
            "not in it - not chosen, interrupted or failed; a run does not tell these apart: b/y.");
}

TEST(Incompleteness, CountsExperimentsWhereTheyAreMany) {
  ThreeExperiments of;
  of.claims[0].checks[0].terms.clear();
  for (char name = 'a'; name <= 'h'; ++name)
    of.claims[0].checks[0].terms.push_back({std::string("b/") + name + "/m"});
  EXPECT_THAT(incompleteness(of.judged), HasSubstr("b/a, b/b, b/c, b/d, b/e, b/f and 2 more."));
}

TEST(RunLimits, BeginWithWhatTheRunLacks) {
  ThreeExperiments of;
  const std::size_t general = run_limits(of.judged, false).size();
  of.judged.run.unfinished = "b/y";
  ASSERT_EQ(run_limits(of.judged, false).size(), general + 1);
  EXPECT_EQ(run_limits(of.judged, false)[0], incompleteness(of.judged));
}

TEST(RunLimits, StandInEveryTableForLatex) {
  ThreeExperiments of;
  EXPECT_THAT(latex_wrapper(of.judged, false), HasSubstr("\\section*{What this run cannot tell}"));
  EXPECT_THAT(latex_wrapper(of.judged, false), Not(HasSubstr("Incomplete")));
  of.judged.run.unfinished = "b/y";
  EXPECT_THAT(latex_wrapper(of.judged, false), HasSubstr("\\section*{Incomplete}\nThis run"));
  EXPECT_THAT(latex_claim_macros(of.judged, false), HasSubstr("% This run is not whole."));
  EXPECT_THAT(latex_claim_table(of.judged.papers[0], false, incompleteness(of.judged)),
              HasSubstr("\\midrule\n\\raggedright This run is not whole."));
  EXPECT_THAT(latex_claim_table(of.judged.papers[0], false), Not(HasSubstr("not whole")));
}

}  // namespace
}  // namespace phytobench
