// SPDX-License-Identifier: MIT
#include "reports/latex_files.hpp"

#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/latex_checker.hpp"
#include "reports/latex_claims.hpp"
#include "reports/latex_tables.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A table of one row and two columns, measured, and two claims of which one rests on times.
struct SmallRun {
  JudgedRun judged;

  explicit SmallRun(bool timed = false) {
    judged.papers.resize(1);
    JudgedPaper& paper = judged.papers[0];
    paper.paper.key = "p";
    paper.claims.tables = {{.id = "t",
                            .paper = "p",
                            .title = "Edges & more",
                            .unit = "1",
                            .note = {},
                            .rows = {"a"},
                            .columns = {"x", "y"},
                            .row_labels = {"[A] 50 %"},
                            .column_labels = {"X", "Y"},
                            .measurement = {},
                            .companions = {},
                            .per = {},
                            .origin = "published",
                            .discussion = {},
                            .values = {{4, 2.5}}}};
    paper.tables = {{.table = &paper.claims.tables[0],
                     .measured = true,
                     .timed = timed,
                     .values = {{{4, 4, 4}, {-2.25, -2.25, -2.25}}},
                     .published_share = {{1, 0.625}},
                     .share = {{{1, 1, 1}, {0.5, 0.4, 0.6}}},
                     .companions = {},
                     .published_per = {},
                     .measured_per = {}}};
    paper.claims.claims.resize(2);
    Claim& exact = paper.claims.claims[0];
    exact.id = "p/exact_one";
    exact.text = "100 % of the \"leaves\" & twigs_";
    exact.published = "-1.5";
    exact.unit = "m^2";
    exact.basis = "paper";
    Claim& late = paper.claims.claims[1];
    late.id = "p/timed";
    late.published = "2";
    late.basis = "assumed";
    paper.judgements = {{.claim = &exact, .verdict = Verdict::reproduced, .measured = "1e-06"},
                        {.claim = &late,
                         .verdict = Verdict::inconclusive,
                         .measured = "2.1 [1.9, 2.3]",
                         .reason = {},
                         .checks = {},
                         .varies = true}};
  }
  const JudgedTable& table() const { return judged.papers[0].tables[0]; }
};

TEST(LatexTable, ShowsPrintedBesideMeasured) {
  const std::string latex = latex_table(SmallRun().table(), false);
  EXPECT_THAT(latex, HasSubstr(R"(\begin{tabular}{@{}lrrrr@{}})"));
  EXPECT_THAT(latex, HasSubstr(R"( & \multicolumn{2}{c}{X} & \multicolumn{2}{c}{Y} \\)"));
  EXPECT_THAT(latex, HasSubstr(" & published & measured & published & measured \\\\\n"));
  EXPECT_THAT(latex, HasSubstr("{[}A{]} 50 \\% & 4 & 4 & 2.5 & $-2.25$ \\\\\n"));
}

TEST(LatexTable, ShowsPrintedAloneWhereNothingIsMeasuredOrTimesAreLeftOut) {
  SmallRun run(true);
  EXPECT_THAT(latex_table(run.table(), false), HasSubstr("measured"));
  EXPECT_THAT(latex_table(run.table(), true), Not(HasSubstr("measured")));
  run.judged.papers[0].tables[0].measured = false;
  EXPECT_THAT(latex_table(run.table(), false), Not(HasSubstr("measured")));
}

TEST(LatexTable, PutsDecimalPointsBelowEachOther) {
  SmallRun run;
  run.judged.papers[0].claims.tables[0].rows = {"a", "b"};
  run.judged.papers[0].claims.tables[0].row_labels = {"a", "b"};
  run.judged.papers[0].claims.tables[0].values = {{4, 2.5}, {12.25, 3}};
  run.judged.papers[0].tables[0].measured = false;
  const std::string latex = latex_table(run.table(), false);
  EXPECT_THAT(latex, HasSubstr("a & 4\\phantom{.00} & 2.5 \\\\\n"));
  EXPECT_THAT(latex, HasSubstr("b & 12.25 & 3\\phantom{.0} \\\\\n"));
}

TEST(LatexShareTable, IsOfMeasuredTimesAlone) {
  EXPECT_EQ(latex_share_table(SmallRun().table(), false), "");
  EXPECT_EQ(latex_share_table(SmallRun(true).table(), true), "");
  EXPECT_THAT(
      latex_share_table(SmallRun(true).table(), false),
      HasSubstr("0.625 & 0.500 \\\\\n &  & {[}1.000, 1.000{]} &  & {[}0.400, 0.600{]} \\\\\n"));
}

TEST(LatexCounts, AddsUpToAllClaims) {
  EXPECT_THAT(latex_counts(SmallRun().judged, false),
              testing::AllOf(HasSubstr("reproduced & 1 & 1 & 0 & 0 & 0 \\\\\n"),
                             HasSubstr("inconclusive & 1 & 0 & 0 & 1 & 0 \\\\\n")));
  EXPECT_THAT(latex_counts(SmallRun().judged, true),
              HasSubstr("inconclusive & 0 & 0 & 0 & 0 & 0 \\\\\n"));
}

TEST(LatexCounts, CallAnErratumWrongAsPrintedAndTellItsKind) {
  SmallRun run;
  run.judged.papers[0].errata = {{.id = "E1", .kind = ErratumKind::formula}};
  run.judged.papers[0].claims.claims[0].erratum = "E1";
  run.judged.papers[0].judgements[0].verdict = Verdict::reproduced_with_erratum;
  EXPECT_THAT(latex_counts(run.judged, false),
              HasSubstr("wrong as printed, holds corrected & 1 & 1 & 0 & 0 & 0 \\\\\n"
                        "of these: formula & 1 & 1 & 0 & 0 & 0 \\\\\n"));
  EXPECT_THAT(latex_claim_macros(run.judged, false),
              HasSubstr("{wrong as printed, holds corrected}{paper}"));
}

TEST(LatexClaimMacros, DefineEveryClaim) {
  const std::string latex = latex_claim_macros(SmallRun().judged, false);
  EXPECT_THAT(latex, HasSubstr(R"(\phytobench@set{p/exact_one}{$1\times 10^{-6}$}{$-1.5$ )"
                               R"(m\textasciicircum{}2}{reproduced}{paper})"));
  EXPECT_THAT(latex, HasSubstr(R"({p/timed}{2.1 {[}1.9, 2.3{]}}{2}{inconclusive}{assumed})"));
}

TEST(LatexClaimMacros, NameTheUnitOnce) {
  SmallRun run;
  Claim& claim = run.judged.papers[0].claims.claims[0];
  claim.published = "180 and 120 degrees";
  claim.unit = "degree";
  EXPECT_THAT(latex_claim_macros(run.judged, false), HasSubstr("{180 and 120 degrees}"));
}

TEST(LatexClaimMacros, NeverStandForNothing) {
  SmallRun run;
  run.judged.papers[0].judgements[0].measured = "";
  run.judged.papers[0].judgements[0].verdict = Verdict::not_measured;
  const std::string latex = latex_claim_macros(run.judged, true);
  EXPECT_THAT(latex, HasSubstr("{p/exact_one}{(not measured)}"));
  EXPECT_THAT(latex, HasSubstr("{p/timed}{(left out: rests on times)}"));
  EXPECT_THAT(latex, Not(HasSubstr("2.1")));
}

TEST(LatexFiles, HoldOneTableEachAndADocumentThatNamesThemAll) {
  const ReportFiles files = latex_files(SmallRun(true).judged, false);
  for (const char* name : {"all", "claims", "claims-p", "counts", "p-t", "p-t-shares"})
    EXPECT_TRUE(files.contains("tables/" + std::string(name) + ".tex")) << name;
  const std::string& all = files.at("tables/all.tex");
  const std::regex input(R"(\\input\{([^}]*)\})");
  std::size_t named = 0;
  for (auto i = std::sregex_iterator(all.begin(), all.end(), input); i != std::sregex_iterator();
       ++i, ++named)
    EXPECT_TRUE(files.contains("tables/" + (*i)[1].str() + ".tex")) << (*i)[1];
  EXPECT_EQ(named, files.size() - 1);
}

TEST(LatexFiles, CallSharesOfFewRoundsARange) {
  EXPECT_THAT(latex_files(SmallRun(true).judged, false).at("tables/all.tex"),
              HasSubstr("Shares of the largest cell; below each its 95 \\% interval, or range of "
                        "fewer than six rounds.}"));
}

void expect_sound(const JudgedRun& judged) {
  for (const auto& [name, latex] : latex_files(judged, false)) {
    EXPECT_THAT(LatexChecker::problems_of(latex), IsEmpty()) << name;
    EXPECT_THAT(latex, Not(HasSubstr("U+"))) << name << ": a letter without a command";
  }
}

TEST(LatexFilesLaw, EveryFileIsSoundLatex) {
  expect_sound(SmallRun(true).judged);
}

TEST(LatexFilesLaw, EveryFileOnTheWorksIsSoundLatex) {
  RunContents nothing;
  nothing.header = {Tier::smoke, 0};
  expect_sound(judge_run(std::move(nothing)));
}

}  // namespace
}  // namespace phytobench
