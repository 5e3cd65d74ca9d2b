// SPDX-License-Identifier: MIT
#include "reports/document_errata.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

struct PaperWithErrata {
  Claim claim;
  JudgedPaper paper;

  PaperWithErrata() {
    claim.id = "b/eq-2";
    paper.paper.key = "b";
    paper.judgements = {{.claim = &claim}};
    paper.errata.resize(2);
    paper.errata[0].id = "E1";
    paper.errata[0].section = "4";
    paper.errata[0].claims = {"b/eq-2", "b/not-loaded"};
    paper.errata[1].id = "E2";
    paper.errata[1].section = "2.1";
    paper.errata[1].counter_example = CounterExample{.oracle = "equation-2",
                                                     .arguments = {1.0, 2.5},
                                                     .inputs = {"radius", "distance"},
                                                     .result = "area",
                                                     .printed = std::nullopt,
                                                     .corrected = 3.0,
                                                     .why = "By hand."};
    paper.assumptions = {{.id = "A1", .question = "Which?", .claims = {"b/eq-2"}}};
  }
};

TEST(Errata, ComeInTheOrderOfTheWork) {
  const auto errata = errata_document(PaperWithErrata().paper);
  EXPECT_EQ(errata[0]["id"], "E2");
  EXPECT_EQ(errata[1]["anchor"], "erratum-b-E1");
}

TEST(Errata, LeadToClaimsThatAreThere) {
  const auto errata = errata_document(PaperWithErrata().paper);
  ASSERT_EQ(errata[1]["claims"].size(), 1u);
  EXPECT_EQ(errata[1]["claims"][0]["anchor"], "claim-b-eq-2");
  EXPECT_EQ(errata[0]["has_claims"], false);
}

TEST(Errata, DoNotCallCorrectedWhatOnlyTheProgramDoesOtherwise) {
  PaperWithErrata of;
  of.paper.errata[0].kind = ErratumKind::program;
  of.paper.errata[1].kind = ErratumKind::formula;
  const auto errata = errata_document(of.paper);
  EXPECT_EQ(errata[0]["other_form"], "Corrected");
  EXPECT_EQ(errata[0]["other_form_short"], "corrected");
  EXPECT_EQ(errata[1]["other_form"], "What the program does");
  EXPECT_EQ(errata[1]["other_form_short"], "in the program");
}

TEST(Errata, NameTheInputsOfTheirExample) {
  const auto example = errata_document(PaperWithErrata().paper)[0]["example"];
  EXPECT_EQ(example["inputs"][1]["name"], "distance");
  EXPECT_EQ(example["inputs"][1]["value"], "2.5");
  EXPECT_EQ(example["printed"], "no value");
  EXPECT_EQ(example["corrected"], "3");
}

TEST(Assumptions, HaveAnchorsAndClaims) {
  const auto assumptions = assumptions_document(PaperWithErrata().paper);
  EXPECT_EQ(assumptions[0]["anchor"], "assumption-b-A1");
  EXPECT_EQ(assumptions[0]["claims"][0]["short_id"], "eq-2");
}

}  // namespace
}  // namespace phytobench
