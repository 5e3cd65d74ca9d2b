// SPDX-License-Identifier: MIT
#include "reports/document_places.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

Claim claim_at(const std::string& id, const std::string& locator,
               const std::string& measurement = "") {
  Claim claim;
  claim.id = id;
  claim.locator = locator;
  if (!measurement.empty()) claim.checks = {{.terms = {{measurement}}}};
  return claim;
}

struct Index {
  std::vector<Claim> claims = {
      claim_at("b/table-1/euclid.s", "Table 1"),
      claim_at("b/appendix/fig-40-left.edges", "appendix table, figure 40 left"),
      claim_at("b/eq-17/holds", "eq. 17", "b/sensitivity/figure-51/edges"),
      claim_at("b/eq-17/fails", "eq. 17, fig. 4")};
  std::vector<Judgement> judgements;
  ClaimIndex index;

  Index() {
    for (const Claim& claim : claims)
      judgements.push_back({.claim = &claim, .verdict = Verdict::reproduced});
    judgements[3].verdict = Verdict::not_reproduced;
    index = ClaimIndex(judgements, false);
  }
  std::string about(const std::string& measurement) const {
    const ClaimLink* const link = index.about(measurement);
    return link ? link->short_id : "";
  }
};

TEST(ClaimIndex, FindsAllClaimsAtAPlace) {
  const Index of;
  ASSERT_EQ(of.index.at({PlaceKind::equation, "17"}).size(), 2u);
  EXPECT_EQ(of.index.at({PlaceKind::equation, "17"})[1].label, "not reproduced");
  EXPECT_TRUE(of.index.at({PlaceKind::equation, "1"}).empty());
}

TEST(ClaimIndex, FindsTheClaimAboutACell) {
  const Index of;
  EXPECT_EQ(of.about("b/table-1/euclid.s/seconds"), "table-1/euclid.s");
  EXPECT_EQ(of.about("b/appendix/figure-40-left/edges"), "appendix/fig-40-left.edges");
  EXPECT_EQ(of.about("b/sensitivity/figure-51/edges"), "eq-17/holds");
}

TEST(ClaimIndex, GivesNoCellAnothersClaim) {
  const Index of;
  EXPECT_EQ(of.about("b/table-1/euclid.d/seconds"), "");
  EXPECT_EQ(of.about("b/appendix/figure-40-left/vertices"), "");
  EXPECT_EQ(of.about("b/eq-17/holds/seconds"), "");  // not a claim about a table
}

TEST(ClaimIndex, SortsPlacesByKindAndClaimsByVerdict) {
  const nlohmann::ordered_json kinds = Index().index.document();
  ASSERT_EQ(kinds.size(), 3u);
  EXPECT_EQ(kinds[0]["title"], "Equations (Gleichungen)");
  ASSERT_EQ(kinds[0]["rows"].size(), 1u);
  EXPECT_EQ(kinds[0]["rows"][0]["place"], "Equation 17");
  EXPECT_EQ(kinds[0]["rows"][0]["groups"][1]["label"], "not reproduced");
  EXPECT_EQ(kinds[1]["rows"][0]["place"], "Figure 4");
  EXPECT_EQ(kinds[1]["rows"][1]["place"], "Figure 40");
}

/// The row of a place among all of a work, of which one claim is known.
nlohmann::ordered_json place_row_of(const std::string& place) {
  Claim claim = claim_at("brzoska2019/eq-17/holds", "eq. 17");
  claim.paper = "brzoska2019";
  const ClaimIndex index({{.claim = &claim, .verdict = Verdict::reproduced}}, false);
  for (const auto& kind : index.document())
    for (const auto& row : kind["rows"])
      if (row["place"] == place) return row;
  return {};
}

TEST(ClaimIndex, SaysWhereNoClaimIs) {
  EXPECT_EQ(place_row_of("Equation 17")["without_claims"], "");
  EXPECT_EQ(place_row_of("Equation 17")["pages"], "p. 39-43");
  EXPECT_EQ(place_row_of("Equation 16")["without_claims"],
            "No checkable statement of its own found; there are claims on Section 5.2.1");
  EXPECT_EQ(place_row_of("Section 5.2")["without_claims"],
            "No claim on it as a whole; there are claims on Section 5.2.1");
  EXPECT_EQ(place_row_of("Figure 23")["without_claims"], "No checkable statement of its own found");
  EXPECT_EQ(place_row_of("Chapter 1")["without_claims"], "No checkable statement found");
  EXPECT_EQ(place_row_of("Figure 23")["has_claims"], false);
  EXPECT_TRUE(place_row_of("Figure 99").is_null());
}

}  // namespace
}  // namespace phytobench
