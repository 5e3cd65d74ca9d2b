// SPDX-License-Identifier: MIT
#include "reports/document_locators.hpp"

#include <gtest/gtest.h>

#include "reference/claims.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

std::string places(const std::string& locator) {
  std::string text;
  for (const Place& place : places_of(locator)) text += (text.empty() ? "" : ", ") + shown(place);
  return text;
}

TEST(Locators, NameOnePlaceOfEachKind) {
  EXPECT_EQ(places("eq. 17"), "Equation 17");
  EXPECT_EQ(places("(4.3)"), "Equation 4.3");
  EXPECT_EQ(places("Table 1"), "Table 1");
  EXPECT_EQ(places("fig. 4.5, full line"), "Figure 4.5");
  EXPECT_EQ(places("sec. 3.4.4"), "Section 3.4.4");
  EXPECT_EQ(places("chapter 5, introduction"), "Chapter 5");
  EXPECT_EQ(places("listing 1"), "Listing 1");
  EXPECT_EQ(places("appendix A"), "Appendix A");
}

TEST(Locators, NameSeveralPlaces) {
  EXPECT_EQ(places("appendix table, figure 40 left"), "Appendix table, Figure 40");
  EXPECT_EQ(places("sec. 3.3.1, 6.1.1, FAO09"), "Section 3.3.1, Section 6.1.1, FAO09");
  EXPECT_EQ(places("(A.2), (A.3)"), "Equation A.2, Equation A.3");
  EXPECT_EQ(places("figures 7.5, 7.9; sec. 7.4, 7.6"),
            "Figure 7.5, Figure 7.9, Section 7.4, Section 7.6");
  EXPECT_EQ(places("summary, sections 1.2 and 9"), "Section 1.2, Chapter 9");
  EXPECT_EQ(places("figures 40 left and 45"), "Figure 40, Figure 45");
  EXPECT_EQ(places("section 1.1, ch. 6"), "Section 1.1, Chapter 6");
  EXPECT_EQ(places("2.1, (2.1)"), "Section 2.1, Equation 2.1");
  EXPECT_EQ(places("(2.1), growth law of 4.3"), "Equation 2.1, Section 4.3");
}

TEST(Locators, FillRanges) {
  EXPECT_EQ(places("(2.15) to (2.17)"), "Equation 2.15, Equation 2.16, Equation 2.17");
  EXPECT_EQ(places("sec. 2.9 to 3.1"), "Section 2.9, Section 3.1");
}

TEST(Locators, LeaveOutWhatIsNoPlace) {
  EXPECT_EQ(places("sec. 2.2, steps 3 and 4"), "Section 2.2");
  EXPECT_EQ(places("figure 5.2 a, c; sec. 5.2.1"), "Figure 5.2, Section 5.2.1");
  EXPECT_EQ(places("appendix table, row 4"), "Appendix table");
  EXPECT_EQ(places("eq. 7, p2, p3; sec. 3.4.2"), "Equation 7, Section 3.4.2");
  EXPECT_EQ(places("sec. 3.4.4 with footnote 2, fig. 20"), "Section 3.4.4, Figure 20");
}

TEST(Locators, KeepATextWithoutAnyPlace) {
  EXPECT_EQ(places("summary"), "summary");
  EXPECT_EQ(search_token(places_of("summary").front()), "");
}

TEST(Locators, ComeInTheOrderOfTheWork) {
  EXPECT_TRUE((Place{PlaceKind::equation, "4.9"} < Place{PlaceKind::equation, "4.11"}));
  EXPECT_FALSE((Place{PlaceKind::equation, "4.11"} < Place{PlaceKind::equation, "4.9"}));
  EXPECT_TRUE((Place{PlaceKind::equation, "9"} < Place{PlaceKind::figure, "1"}));
  EXPECT_FALSE((Place{PlaceKind::figure, "1"} < Place{PlaceKind::figure, "1"}));
}

/// Almost all claims can be found by a numbered place of their work.
TEST(Locators, OfClaimsAreUnderstood) {
  std::size_t claims = 0, numbered = 0;
  std::string others;
  for (const std::string& paper : paper_keys())
    for (const Claim& claim : load_claims(paper).claims) {
      ++claims;
      const bool found = places_of(claim.locator).front().kind != PlaceKind::other;
      numbered += found;
      if (!found) others += claim.locator + "\n";
    }
  EXPECT_GT(static_cast<double>(numbered), 0.97 * static_cast<double>(claims)) << others;
}

}  // namespace
}  // namespace phytobench
