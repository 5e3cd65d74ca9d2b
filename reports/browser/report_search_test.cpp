// SPDX-License-Identifier: MIT
// How a reader gets to claims by filter, search and links from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/browser/report_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::IsEmpty;

constexpr int most_layouts = 60;  ///< of a search for eight letters, far below one for each claim

/// Chooses an entry of a list by its text, with or without a number in brackets.
void choose(Page& page, const std::string& list, const std::string& entry) {
  page.evaluate(fmt::format(R"js((() => {{
    const list = document.querySelector('#filter select[name={}]');
    const entry = [...list.options].find(e => e.text.replace(/ \(\d+\)$/, '') === {});
    list.value = entry.value;
    list.dispatchEvent(new Event('input', {{ bubbles: true }}));
    list.dispatchEvent(new Event('change', {{ bubbles: true }}));
  }})())js",
                            list, quoted(entry)));
  page.wait_until("location.hash.includes('" + list + "=')");
}

void search(Page& page, const std::string& text) {
  const std::string field = "document.querySelector('#filter [name=q]')";
  page.click(field);
  page.evaluate(field + ".select()");
  page.type(text);
  page.wait_until(
      fmt::format("new URLSearchParams(location.hash.slice(2)).get('q') === {}", quoted(text)));
}

std::string count_line(Page& page) {
  return page.evaluate("document.getElementById('shown').textContent").get<std::string>();
}

TEST_F(ReportInBrowserSlow, TheFilterShowsTheClaimsOfAVerdictAndAWork) {
  Page& page = opened();
  EXPECT_EQ(shown_claims(), all_claims());
  choose(page, "verdict", "not reproduced");
  const auto refuted = [](const json& claim) { return claim["verdict"] == "not reproduced"; };
  const Anchors expected = claims_that(refuted);
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(shown_claims(), expected);
  EXPECT_THAT(count_line(page), testing::StartsWith(std::to_string(expected.size()) + " of "));
  page.evaluate(
      "(e => { e.value = 'alsweis'; e.dispatchEvent(new Event('input', { bubbles: true })); })("
      "document.querySelector('#filter select[name=paper]'))");
  page.wait_until("location.hash.includes('paper=alsweis')");
  EXPECT_EQ(shown_claims(), claims_that([&](const json& claim) {
              return refuted(claim) && is_of(claim, "alsweis");
            }));
  page.click("document.querySelector('#filter [type=reset]')");
  page.wait_until("location.hash === ''");
  EXPECT_EQ(shown_claims(), all_claims());
  EXPECT_THAT(count_line(page), testing::StartsWith(std::to_string(claims_.size()) + " "));
}

TEST_F(ReportInBrowserSlow, EveryVerdictInTheFilterHasTheNumberOfClaimsBehindIt) {
  Page& page = opened();
  const auto entries = page.texts(
      "[...document.querySelectorAll('#filter select[name=verdict] option')].map(e => e.text)"
      ".filter(text => text.endsWith(')'))");
  EXPECT_GE(entries.size(), 5u);
  for (const std::string& entry : entries) {
    const std::size_t bracket = entry.rfind(" (");
    page.evaluate("history.replaceState(null, '', '#')");
    choose(page, "verdict", entry.substr(0, bracket));
    EXPECT_EQ("(" + std::to_string(shown_claims().size()) + ")", entry.substr(bracket + 1));
  }
}

TEST_F(ReportInBrowserSlow, TheAddressKeepsTheFilter) {
  Page& page = opened();
  choose(page, "verdict", "not reproduced");
  const Anchors shown = shown_claims();
  const std::string address = page.evaluate("location.hash").get<std::string>();
  opened(address);
  EXPECT_EQ(shown_claims(), shown);
  page.click("document.querySelector('nav a[href=\"#attention\"]')");  // which the filter hides
  page.wait_until("location.hash === '#attention'");
  EXPECT_EQ(shown_claims(), all_claims());
  page.evaluate("history.back()");
  EXPECT_NO_THROW(page.wait_until("document.getElementById('shown').textContent.includes(' of ')"));
  EXPECT_EQ(page.evaluate("location.hash"), address);
  EXPECT_EQ(shown_claims(), shown);
}

struct PlaceSearch {
  std::string text;
  Place place;
};

TEST_F(ReportInBrowserSlow, TheSearchFindsPlacesInTheWordsOfTheWorks) {
  Page& page = opened();
  for (const auto& [text, place] : std::vector<PlaceSearch>{
           {"eq. 17", {PlaceKind::equation, "17"}},
           {"Gl. 17", {PlaceKind::equation, "17"}},
           {"EQUATION (17)", {PlaceKind::equation, "17"}},
           {"(4.3)", {PlaceKind::equation, "4.3"}},
           {"Table 1", {PlaceKind::table, "1"}},
           {"Tabelle 1", {PlaceKind::table, "1"}},
           {"Abb. 8", {PlaceKind::figure, "8"}},
           {"fig. 8", {PlaceKind::figure, "8"}},
           {"Abschnitt 3.2", {PlaceKind::section, "3.2"}},
       }) {
    search(page, text);
    const Anchors expected = claims_that([&](const json& c) { return has_place(c, place); });
    EXPECT_FALSE(expected.empty()) << text;
    EXPECT_EQ(shown_claims(), expected) << text;
  }
}

TEST_F(ReportInBrowserSlow, TheSearchFindsIdsAndWords) {
  Page& page = opened();
  const std::string id = claims_[claims_.size() / 2]["id"];
  search(page, id);
  EXPECT_EQ(shown_claims(),
            claims_that([&](const json& c) { return c["id"].get<std::string>().starts_with(id); }));
  search(page, "growth");
  const Anchors with_word = shown_claims();
  EXPECT_THAT(with_word, testing::SizeIs(testing::AllOf(testing::Gt(3u), testing::Lt(400u))));
  for (const std::string& anchor : with_word)
    EXPECT_TRUE(page.holds("document.getElementById(" + quoted(anchor) +
                           ").closest('.claim').textContent.toLowerCase().includes('growth')"));
  search(page, "nowhere to be found");
  EXPECT_THAT(shown_claims(), IsEmpty());
  EXPECT_TRUE(page.holds("document.getElementById('no-match').checkVisibility()"));
}

/// A search and a part of the name of a claim that it must find.
TEST_F(ReportInBrowserSlow, TheSearchUnderstandsWhatTheWorksPrint) {
  Page& page = opened();
  for (const auto& [text, id] : std::vector<std::pair<std::string, std::string>>{
           {"49,3", "table-1/euclid.s"},
           {"Tabelle 1 Voxelgrid", "table-1/voxel.dn"},
           {"Euklidischer Abstand 49,3", "table-1/euclid.s"},
           {"Abbildung 46 (Rechts)", "appendix/fig-46-right.seconds"},
           {"Abb. 46 mitte", "appendix/fig-46-middle.vertices"},
           {"Anhang", "appendix/fig-52.seconds"},
           {"Anhang A", "appendix/fig-52.seconds"},
           {"10.292", "appendix/fig-40-left.vertices"},
           {"FAO9", "fao09"},
           {"FAO09", "fao09"},
           {"D&N", "table-1/voxel.dn"},
           {"D & N", "table-1/voxel.dn"},
           {"S. 45", "eq-23/distance"},
           {"Seite 45", "table-1/voxel.dn"},
           {"L\u00f6schdistanz", "eq-17/formula"},
           {"Loeschdistanz", "eq-17/formula"},
           {"Gleichung 17", "eq-17/formula"},
       }) {
    search(page, text);
    const Anchors named = claims_that([&, part = id](const json& claim) {
      return claim["id"].get<std::string>().find(part) != std::string::npos;
    });
    ASSERT_FALSE(named.empty()) << id;
    EXPECT_THAT(shown_claims(), testing::IsSupersetOf(named)) << text;
    EXPECT_THAT(shown_claims(), testing::SizeIs(testing::Lt(claims_.size() / 4))) << text;
  }
}

TEST_F(ReportInBrowserSlow, GermanWordsFindWhatTheEnglishOnesFind) {
  Page& page = opened();
  for (const char* word : {"Wang", "Kacheln", "Wang-Kacheln"}) {
    search(page, word);
    EXPECT_THAT(shown_claims(), testing::SizeIs(testing::Gt(5u))) << word;
    EXPECT_THAT(page.texts("phytobenchQuery(phytobenchPlain(" + quoted(word) + ")).words[0]"),
                testing::Contains("tile"));
  }
  const auto useless = page.texts(R"js((() => {
    const texts = [...document.querySelectorAll('details.claim')].map(e => phytobenchPlain(e.textContent));
    return phytobenchWords.filter(entry => !entry.slice(1).some(
        form => texts.some(text => text.includes(form)))).map(entry => entry.join(' '));
  })())js");
  EXPECT_THAT(useless, IsEmpty()) << "no claim has any of these";
}

std::string answer_to(Page& page, const std::string& text) {
  search(page, text);
  return page
      .evaluate(
          "(e => e.checkVisibility() ? e.textContent : '')(document.getElementById("
          "'no-match'))")
      .get<std::string>();
}

TEST_F(ReportInBrowserSlow, APlaceWithoutClaimIsToldFromOneThatIsNot) {
  Page& page = opened();
  EXPECT_THAT(answer_to(page, "Abb. 23"),
              testing::AllOf(testing::StartsWith("Figure 23 (p. 28) of Donat Deva Brzoska 2019: "),
                             testing::HasSubstr("Section 3.5")));
  EXPECT_THAT(answer_to(page, "Figure 3.9"), testing::HasSubstr("Monssef Alsweis"));
  EXPECT_EQ(answer_to(page, "Abb. 99"), "None of the works has a figure 99.");
  EXPECT_EQ(answer_to(page, "Gl. 99"), "None of the works has an equation 99.");
  EXPECT_THAT(answer_to(page, "Seite 999"), testing::HasSubstr("page 999"));
  EXPECT_EQ(answer_to(page, "Abb. 46"), "");
  EXPECT_THAT(answer_to(page, "nowhere to be found"), testing::StartsWith("No claim matches."));
}

TEST_F(ReportInBrowserSlow, CaseAndDashesDoNotMatterToTheSearch) {
  Page& page = opened();
  search(page, "kill-distance");
  const Anchors shown = shown_claims();
  EXPECT_THAT(shown, testing::SizeIs(testing::Gt(3u)));
  for (const char* same : {"KILL-DISTANCE", "kill\u2013distance", "kill\u2011distance"}) {
    search(page, same);
    EXPECT_EQ(shown_claims(), shown) << same;
  }
  search(page, "Kill distance");  // words that need not stand together
  EXPECT_THAT(shown_claims(), testing::IsSupersetOf(shown));
}

int layouts(Page& page) {
  const json metrics = page.call("Performance.getMetrics")["metrics"];
  for (const json& metric : metrics)
    if (metric["name"] == "LayoutCount") return metric["value"].get<int>();
  return -1;
}

TEST_F(ReportInBrowserSlow, TypingCostsNoLayoutForEachClaim) {
  Page& page = opened();
  page.call("Performance.enable");
  const int before = layouts(page);
  search(page, "distance");
  EXPECT_GT(layouts(page), before);
  EXPECT_LT(layouts(page) - before, most_layouts);
}

TEST_F(ReportInBrowserSlow, ALinkToAClaimOpensIt) {
  const Anchors claims = all_claims();
  for (const std::size_t share : {1u, 2u, 3u}) {
    const std::string& anchor = claims[claims.size() * share / 4];
    EXPECT_NO_THROW(opened("#" + anchor).wait_until(is_revealed(anchor))) << anchor;
  }
  Page& page = opened();
  choose(page, "verdict", "not reproduced");
  const Anchors hidden =
      claims_that([](const json& claim) { return claim["verdict"] == "reproduced"; });
  page.evaluate("location.hash = " + quoted("#" + hidden.back()));
  EXPECT_NO_THROW(page.wait_until(is_revealed(hidden.back()))) << "although the filter hides it";
}

}  // namespace
}  // namespace phytobench
