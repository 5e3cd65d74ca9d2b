// SPDX-License-Identifier: MIT
#include "reports/document_anchors.hpp"

#include <set>

#include <gtest/gtest.h>

#include "reference/claims.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

TEST(Anchors, AreLettersDigitsAndSingleDashes) {
  EXPECT_EQ(slug("not reproduced"), "not-reproduced");
  EXPECT_EQ(slug("reproduced, fitted"), "reproduced-fitted");
  EXPECT_EQ(slug("(4.3) gl\xc3\xbc"), "4-3-gl");
  EXPECT_EQ(claim_anchor("b/table-1/euclid.s"), "claim-b-table-1-euclid-s");
}

TEST(Anchors, OfAllClaimsDiffer) {
  std::set<std::string> anchors;
  for (const std::string& paper : paper_keys())
    for (const Claim& claim : load_claims(paper).claims)
      EXPECT_TRUE(anchors.insert(claim_anchor(claim.id)).second) << claim.id;
}

TEST(Anchors, ShortIdsLeaveOutTheWork) {
  EXPECT_EQ(short_claim_id("b/eq-17/reading"), "eq-17/reading");
  EXPECT_EQ(short_claim_id("bare"), "bare");
}

}  // namespace
}  // namespace phytobench
