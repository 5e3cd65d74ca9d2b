// SPDX-License-Identifier: MIT
#include "reports/document_errata_kinds.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

Claim claim_with(const std::string& erratum) {
  Claim claim;
  claim.erratum = erratum;
  return claim;
}

/// Claims of a formula twice (one of them timed), of a program, of an unsorted erratum, and one
/// that fails even with its erratum.
struct Corrections {
  Claim formula = claim_with("E1"), timed = claim_with("E1"), program = claim_with("E2"),
        unsorted = claim_with("E3"), fails = claim_with("E1");
  JudgedPaper paper;

  Corrections() {
    paper.errata.resize(3);
    paper.errata[0].id = "E1";
    paper.errata[0].kind = ErratumKind::formula;
    paper.errata[1].id = "E2";
    paper.errata[1].kind = ErratumKind::program;
    paper.errata[2].id = "E3";
    const Verdict corrected = Verdict::reproduced_with_erratum;
    paper.judgements = {{.claim = &unsorted, .verdict = corrected},
                        {.claim = &program, .verdict = corrected},
                        {.claim = &formula, .verdict = corrected},
                        {.claim = &timed, .verdict = corrected, .varies = true},
                        {.claim = &fails, .verdict = Verdict::not_reproduced}};
  }
};

TEST(ErrataKinds, CountEachCorrectedClaimOnceInTheOrderOfTheKinds) {
  const Corrections of;
  const auto kinds = corrected_by_kind({&of.paper, 1}, false);
  ASSERT_EQ(kinds.size(), 3u);
  EXPECT_EQ(kinds[0].kind, "formula");
  EXPECT_EQ(kinds[0].count, 2u);
  EXPECT_EQ(kinds[1].kind, "differs from the program");
  EXPECT_EQ(kinds[2].kind, "kind not told");
}

TEST(ErrataKinds, LeaveOutWhatRestsOnTimesIfAskedTo) {
  const Corrections of;
  EXPECT_EQ(errata_kinds_document(of.paper, false)[0]["count"], 2);
  EXPECT_EQ(errata_kinds_document(of.paper, true)[0]["count"], 1);
}

TEST(ErrataKinds, KnowEveryKind) {
  for (int i = 0; i <= static_cast<int>(ErratumKind::program); ++i) {
    Corrections of;
    of.paper.errata[0].kind = static_cast<ErratumKind>(i);
    of.paper.judgements.erase(of.paper.judgements.begin(), of.paper.judgements.begin() + 2);
    EXPECT_EQ(corrected_by_kind({&of.paper, 1}, false).size(), 1u) << i;
  }
}

}  // namespace
}  // namespace phytobench
