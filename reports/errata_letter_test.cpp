// SPDX-License-Identifier: MIT
#include "reports/errata_letter.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/errata_letter_counts.hpp"
#include "reports/errata_letter_strongest.hpp"
#include "reports/errata_letter_text.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

Claim claim_in_letter(const std::string& id, const std::string& basis) {
  Claim claim;
  claim.id = id;
  claim.locator = "eq. 2";
  claim.text = "It grows with " + id;
  claim.published = "-";
  claim.basis = basis;
  claim.reason = "Because.";
  return claim;
}

/// A work with two errata in the wrong order, one question and five claims.
struct SmallWork {
  Claim plain = claim_in_letter("w/plain", "paper"),
        corrected = claim_in_letter("w/corrected", "paper"),
        read = claim_in_letter("w/read", "assumed"),
        refuted = claim_in_letter("w/refuted", "paper"),
        timed = claim_in_letter("w/timed", "paper");
  JudgedPaper work;

  SmallWork() {
    corrected.erratum = "E1";
    work.paper = {.key = "w",
                  .title = "Plants",
                  .author = "A. Author",
                  .year = "1999",
                  .kind = "thesis",
                  .summary = ""};
    work.errata = {{.id = "E2",
                    .section = "4.10",
                    .locator = "eq. 7",
                    .printed = "a",
                    .corrected = "b",
                    .consequence = "Less light.",
                    .confidence = "probable"},
                   {.id = "E1",
                    .section = "4.9",
                    .locator = "eq. 2",
                    .kind = ErratumKind::formula,
                    .printed = "n = V / rho",
                    .corrected = "n = V * rho",
                    .consequence = "Too few points",
                    .check = "Put in numbers",
                    .confidence = "certain",
                    .claims = {"w/corrected", "w/unknown"},
                    .counter_example = CounterExample{.oracle = "o",
                                                      .arguments = {843.2537, 30.0},
                                                      .inputs = {"volume V", "density rho"},
                                                      .result = "points",
                                                      .printed = 28.1084567,
                                                      .corrected = 25298.0,
                                                      .why = "The test tree"}}};
    work.assumptions = {{.id = "A1",
                         .locator = "sec. 3",
                         .question = "Which one",
                         .reading = "The first",
                         .alternatives = "16 edges instead of 5200",
                         .claims = {"w/read", "w/refuted"}}};
    work.judgements = {{.claim = &plain, .verdict = Verdict::reproduced},
                       {.claim = &corrected, .verdict = Verdict::reproduced_with_erratum},
                       {.claim = &read, .verdict = Verdict::reproduced},
                       {.claim = &refuted,
                        .verdict = Verdict::not_reproduced,
                        .checks = {{.wanted = ">= 1",
                                    .outcome = CheckOutcome::fails,
                                    .terms = {{"w/ratio", "0.900123", CheckOutcome::fails}}}}},
                       {.claim = &timed, .verdict = Verdict::reproduced, .varies = true}};
  }
};

TEST(ErrataLetter, HoldsAllOfAnErratumInTheOrderOfTheWork) {
  const std::string letter = errata_letter(SmallWork().work, false);
  EXPECT_THAT(letter, HasSubstr("# Notes on \"Plants\"\n\nA. Author, 1999, thesis."));
  EXPECT_LT(letter.find("### E1: eq. 2 (section 4.9)"), letter.find("### E2: eq. 7"));
  for (const char* part :
       {"**Printed:** n = V / rho", "**Corrected:** n = V * rho",
        "volume V = 843.2537; density rho = 30. Sought: points. As printed: **28.10846**; "
        "corrected: **25298**. The test tree.",
        "**What follows:** Too few points.",
        "  - eq. 2: It grows with w/corrected. *(is wrong as printed and holds corrected)*",
        "**To check it:** Put in numbers.", "**Kind:** formula", "**Confidence:** certain"})
    EXPECT_THAT(letter, HasSubstr(part));
  EXPECT_THAT(letter, Not(HasSubstr("w/unknown"))) << "a claim that was not judged";
}

TEST(ErrataLetter, SaysWhereThePrintedFormHasNoValue) {
  SmallWork small;
  small.work.errata[1].counter_example->printed.reset();
  EXPECT_THAT(errata_letter(small.work, false), HasSubstr("As printed: **no value**"));
}

TEST(ErrataLetter, DoesNotCorrectWhatOnlyTheProgramDoesOtherwise) {
  SmallWork small;
  EXPECT_THAT(errata_letter(small.work, false), Not(HasSubstr("program (")));
  small.work.errata[1].kind = ErratumKind::program;
  const std::string letter = errata_letter(small.work, false);
  EXPECT_THAT(letter, HasSubstr("leaves a case out (1, of which 0 are certain), where it differs "
                                "from the published program (1),"));
  const std::size_t part = letter.find("## Where the text differs from the published program");
  EXPECT_LT(letter.find("### E2: eq. 7"), part);
  const std::string of_program = letter.substr(part, letter.find("## Where the text can") - part);
  for (const char* line :
       {"### E1: eq. 2", "**In the program:** n = V * rho", "in the program: **25298**",
        "*(holds for the program)*", "**Confidence:** certain"})
    EXPECT_THAT(of_program, HasSubstr(line));
  EXPECT_THAT(of_program, Not(HasSubstr("orrected:")));
}

TEST(ErrataLetter, SaysOfProbableEntriesThatTheyAreInferred) {
  SmallWork small;
  EXPECT_THAT(errata_letter(small.work, false),
              HasSubstr("probable: something seems wrong here, and the correction is our"));
  small.work.errata[0].kind = ErratumKind::program;
  EXPECT_THAT(errata_letter(small.work, false), HasSubstr("probable: the text may be meant less"));
}

TEST(ErrataLetter, TellsDerivedNumbersFromPrintedOnes) {
  SmallWork small;
  small.refuted.published = "derived: 18";
  EXPECT_THAT(errata_letter(small.work, false), HasSubstr(" Follows from print: 18. Because."));
  small.refuted.published = "derived from the order of its times: 20";
  EXPECT_THAT(errata_letter(small.work, false),
              HasSubstr(" Follows from the order of its times: 20. Because."));
  small.refuted.published = "18";
  EXPECT_THAT(errata_letter(small.work, false), HasSubstr(" Printed: 18. Because."));
}

TEST(ErrataLetter, SpeaksOfRefutedStatementsInSentences) {
  SmallWork small;
  small.refuted.reason = "It takes rain (plain). (The expected verdict was set later.)";
  JudgedCheck& check = small.work.judgements[3].checks[0];
  check.terms[0].measured = "3e-76";
  check.terms.push_back({"w/b", "9.4 [9.1, 9.7]", CheckOutcome::fails});
  check.wanted = "<= 0.5 in 2 of 2";
  EXPECT_THAT(errata_letter(small.work, false),
              HasSubstr(" It takes rain (eq. 2). Measured in this way: practically 0 (3e-76), 9.4 "
                        "(9.1 to 9.7); needed: at most 0.5 in 2 of 2 cases.\n"));
  check.terms.resize(20);
  EXPECT_THAT(errata_letter(small.work, false), HasSubstr("(eq. 2). Of 20 comparisons 2 fail.\n"));
}

TEST(ErrataLetter, ShortensLongListsOfStatements) {
  SmallWork small;
  small.work.errata[1].claims.assign(9, "w/plain");
  const std::string letter = errata_letter(small.work, false);
  EXPECT_THAT(letter, HasSubstr("\n  - and 3 more\n"));
}

TEST(ErrataLetter, OpensWithLinksToWhatWeighsMost) {
  const std::string letter = errata_letter(SmallWork().work, false);
  EXPECT_THAT(letter, HasSubstr("\n1. [E1](#erratum-E1), eq. 2 (section 4.9). Printed: n = V / "
                                "rho. Corrected: n = V * rho. Too few points.\n2. [E2]"));
  EXPECT_THAT(letter, HasSubstr("<a id=\"erratum-E1\"></a>\n\n### E1: "));
  EXPECT_LT(letter.find("1. [E1]"), letter.find("## Where the text contradicts"));
}

TEST(StrongestErrata, FollowTheirRule) {
  const auto erratum = [](const char* id, const char* section, ErratumKind kind,
                          const char* confidence, std::size_t claims, bool example) {
    Erratum made{.id = id, .section = section, .kind = kind, .confidence = confidence};
    made.claims.resize(claims);
    if (example) made.counter_example = CounterExample{};
    return made;
  };
  JudgedPaper work;
  work.errata = {erratum("probable", "1", ErratumKind::formula, "probable", 9, true),
                 erratum("argued", "1", ErratumKind::formula, "certain", 9, false),
                 erratum("word", "1", ErratumKind::wording, "certain", 9, true),
                 erratum("case", "1", ErratumKind::missing_case, "certain", 9, true),
                 erratum("program", "1", ErratumKind::program, "certain", 9, true),
                 erratum("one", "1", ErratumKind::formula, "certain", 1, true),
                 erratum("later", "3", ErratumKind::number, "certain", 2, true),
                 erratum("two", "2", ErratumKind::formula, "certain", 2, true)};
  std::vector<std::string> ids;
  for (const Erratum* strong : strongest_errata(work)) ids.push_back(strong->id);
  EXPECT_THAT(ids, testing::ElementsAre("two", "later", "one", "case", "word"));
  work.errata.resize(2);
  ASSERT_EQ(strongest_errata(work).size(), 2u);
  EXPECT_EQ(strongest_errata(work)[0]->id, "argued");
}

TEST(ErrataLetter, EndsASentenceOnlyAtItsEnd) {
  EXPECT_EQ(first_sentence("By eq. 9 and sec. 4.1 it fails. The rest holds."),
            "By eq. 9 and sec. 4.1 it fails.");
  EXPECT_EQ(first_sentence("No stop"), "No stop");
  EXPECT_EQ(first_sentence("Why? So."), "Why?");
  EXPECT_EQ(as_sentence("It holds. (In words.)"), "It holds. (In words.)");
  EXPECT_EQ(as_sentence("It holds (in words)"), "It holds (in words).");
}

TEST(ErrataLetter, AsksQuestionsAndSaysWhatRestsOnThem) {
  const std::string letter = errata_letter(SmallWork().work, false);
  EXPECT_THAT(letter, HasSubstr("### A1: sec. 3\n\n- **Question:** Which one.\n"));
  EXPECT_THAT(letter, HasSubstr("**Otherwise:** 16 edges instead of 5200."));
  EXPECT_THAT(letter, HasSubstr("**Statements that rest on it:** 1 holds under our reading, 1 does "
                                "not hold"));
}

TEST(ErrataLetter, CountsWhatWasConfirmedAndWhatWasNot) {
  const std::string letter = errata_letter(SmallWork().work, false);
  EXPECT_THAT(letter, HasSubstr("into 5 statements. 5 of them were decided"));
  EXPECT_THAT(letter, HasSubstr("- 2 hold as they stand\n"));
  EXPECT_THAT(letter, HasSubstr("- 1 is wrong as printed and holds corrected\n"));
  EXPECT_THAT(letter, HasSubstr("What is wrong with those that hold corrected: a formula (1).\n"));
  EXPECT_THAT(letter, HasSubstr("- eq. 2: It grows with w/refuted. Because. Measured in this way: "
                                "0.900123; needed: at least 1.\n"));
}

TEST(ErrataLetter, LeavesOutWhatRestsOnTimesIfAskedTo) {
  const std::string letter = errata_letter(SmallWork().work, true);
  EXPECT_THAT(letter, HasSubstr("into 5 statements. 4 of them were decided"));
  EXPECT_THAT(letter, HasSubstr("- 1 holds as it stands\n"));
  EXPECT_THAT(letter, HasSubstr("- 1 left out: rests on times\n"));
}

TEST(ErrataLetter, KnowsAPlainWordForEveryVerdict) {
  for (const Verdict verdict : all_verdicts)
    for (const char* basis : {"paper", "author-published", "assumed", "fitted"}) {
      const Claim claim = claim_in_letter("w/a", basis);
      const Judgement judgement{.claim = &claim, .verdict = verdict};
      const std::vector<const Judgement*> one = {&judgement};
      ASSERT_EQ(verdict_counts(one, false).size(), 1u) << name_of(verdict) << ", " << basis;
      EXPECT_EQ(verdict_counts(one, false)[0], "1 " + plain_verdict(judgement, false));
    }
}

TEST(ErrataLetter, DoesNotCallADisagreementNoise) {
  const Claim claim = claim_in_letter("w/a", "paper");
  const Judgement noisy{.claim = &claim, .verdict = Verdict::inconclusive};
  Judgement contradicted = noisy;
  contradicted.contradicted = true;
  const std::vector<const Judgement*> all = {&contradicted, &noisy, &contradicted};
  EXPECT_THAT(
      verdict_counts(all, false),
      testing::ElementsAre("1 could not be decided", "2 could not be decided: the runs disagree"));
}

TEST(ErrataLetter, EscapesOnlyWhatMarkdownWouldTakeForMarkup) {
  for (const char* formula :
       {"n = V * rho", "r_i^2 (theta_i - sin theta_i)", "r_i < d < r_i + r_j", "a in [10, 100]",
        "min_i |p_j - p_i|", "(n + g) / |n + g|", "p < 0.5"})
    EXPECT_EQ(with_literal_markdown(formula), formula);
  EXPECT_EQ(with_literal_markdown("*a* _b_ `c` <d> [e](f) g\\h"),
            "\\*a\\* \\_b\\_ \\`c\\` \\<d> [e\\](f) g\\\\h");
  EXPECT_EQ(with_literal_markdown("two\nlines"), "two lines");
  EXPECT_EQ(with_literal_markdown("*"), "*") << "alone it is no markup";
  EXPECT_EQ(with_literal_markdown(""), "");
}

TEST(ErrataLetter, OfTheRealWorksIsWhole) {
  for (const JudgedPaper& paper : judge_run({}).papers) {
    const std::string letter = errata_letter(paper, false);
    for (const Erratum& erratum : paper.errata)
      EXPECT_THAT(letter, HasSubstr("### " + erratum.id + ": "));
    for (const Assumption& assumption : paper.assumptions)
      EXPECT_THAT(letter, HasSubstr("### " + assumption.id + ": "));
    EXPECT_THAT(letter, Not(HasSubstr("..\n")));
    EXPECT_THAT(letter, Not(HasSubstr("phytobench")));
    EXPECT_THAT(letter, Not(HasSubstr("ledger")));
  }
}

}  // namespace
}  // namespace phytobench
