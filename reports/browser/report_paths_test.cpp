// SPDX-License-Identifier: MIT
// How a reader who has the work at hand gets to a claim: by its place, or its cell of a table.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"
#include "reports/browser/report_fixture.hpp"
#include "reports/document_places_known.hpp"

namespace phytobench {
namespace {

using nlohmann::json;

constexpr std::uint64_t seed = 2019;
constexpr std::size_t sampled_places = 6;  ///< of each work
constexpr std::size_t sampled_cells = 4;

/// Equations and tables of a work that claims are about, in a random order.
std::vector<Place> some_places(const json& claims, const std::string& paper) {
  std::set<Place> places;
  for (const json& claim : claims)
    for (const Place& place : places_of(claim["locator"].get<std::string>()))
      if (is_of(claim, paper) &&
          (place.kind == PlaceKind::equation || place.kind == PlaceKind::table))
        places.insert(place);
  const std::vector<Place> all(places.begin(), places.end());
  CounterStream stream(seed, 0);
  std::vector<Place> some;
  for (const std::size_t index : random_order(all.size(), stream))
    if (some.size() < sampled_places) some.push_back(all[index]);
  return some;
}

/// Clicks the first of the links, which lead to claims; returns where it leads.
std::string follow(Page& page, const std::string& links) {
  const std::string anchor =
      page.evaluate(links + "[0]?.getAttribute('href').slice(1) ?? 'no link'").get<std::string>();
  page.click(links + "[0]");
  return anchor;
}

/// As if loaded anew, which takes longer: at the top, all folded.
void go_to_top(Page& page) {
  page.evaluate(
      "history.replaceState(null, '', '#');"
      "document.querySelectorAll('main details[open]').forEach(e => { e.open = false; });"
      "window.scrollTo(0, 0)");
}

/// Clicks the index of places in the contents, and the first claim on a place in it.
void expect_found(Page& page, const std::string& paper, const Place& place,
                  const Anchors& expected) {
  SCOPED_TRACE(paper + ", " + shown(place));
  page.click("document.querySelector('nav a[href=\"#" + paper + "-places\"]')");
  const std::string anchor =
      follow(page, fmt::format("[...document.querySelectorAll('#{}-places tr')].find(row => "
                               "row.dataset.place === {})?.querySelectorAll('a')",
                               paper, quoted(search_token(place))));
  EXPECT_NO_THROW(page.wait_until(is_revealed(anchor)));
  EXPECT_THAT(expected, testing::Contains(anchor));
}

TEST_F(ReportInBrowserSlow, TwoClicksLeadFromTheTopToAnEquationOrTable) {
  Page& page = opened();
  for (const std::string paper : {"brzoska2019", "alsweis"}) {
    const std::vector<Place> places = some_places(claims_, paper);
    ASSERT_EQ(places.size(), sampled_places);
    for (const Place& place : places) {
      go_to_top(page);
      expect_found(page, paper, place, claims_that([&](const json& claim) {
                     return is_of(claim, paper) && has_place(claim, place);
                   }));
    }
  }
}

TEST_F(ReportInBrowserSlow, OneMoreClickDoesItInANarrowWindow) {
  page_->set_size(narrow_width, narrow_height);
  for (const std::string paper : {"brzoska2019", "alsweis"}) {
    const Place place = some_places(claims_, paper).front();
    opened().click("document.querySelector('#contents summary')");
    expect_found(*page_, paper, place, claims_that([&](const json& claim) {
      return is_of(claim, paper) && has_place(claim, place);
    }));
  }
}

TEST_F(ReportInBrowserSlow, TwoClicksLeadFromTheTopToACellOfATable) {
  Page& page = opened();
  CounterStream stream(seed, 1);
  for (std::size_t cell = 0; cell < sampled_cells; ++cell) {
    go_to_top(page);
    page.click("document.querySelector('nav a[href=\"#brzoska2019-tables\"]')");
    const std::string links = fmt::format(
        "(list => list.slice({} * list.length))([...document.querySelectorAll("
        "'#brzoska2019 td a[href^=\"#claim-\"]')].filter(e => e.checkVisibility()))",
        stream.next_unit());
    const std::string anchor = follow(page, links);
    EXPECT_NO_THROW(page.wait_until(is_revealed(anchor))) << anchor;
  }
}

TEST_F(ReportInBrowserSlow, EveryCellOfTheAppendixLeadsToItsClaim) {
  Page& page = opened();
  const auto cells = page.texts(
      "[...document.querySelectorAll('#table-brzoska2019-appendix ~ .grids')][0]"
      ".querySelector('table').tBodies[0].innerText.split('\\n')");
  EXPECT_EQ(cells.size(), 22u) << "rows of the printed table";
  EXPECT_THAT(cells, testing::Contains("Figure 46 middle\t15344\t20046\t1.6"));
  EXPECT_EQ(page.evaluate("document.querySelector('#table-brzoska2019-appendix ~ .grids table')"
                          ".querySelectorAll('a[href^=\"#claim-\"]').length"),
            66);
}

TEST_F(ReportInBrowserSlow, EveryPlaceOfTheWorksIsInTheIndex) {
  Page& page = opened();
  for (const std::string paper : {"brzoska2019", "alsweis"})
    for (const KnownPlace& known : known_places(paper)) {
      const json row = page.evaluate(fmt::format(
          "document.querySelector('#{}-places tr[data-place=\"{}\"] td')?.textContent ?? null",
          paper, search_token(known.place)));
      ASSERT_TRUE(row.is_string()) << shown(known.place);
      EXPECT_NE(row.get<std::string>(), "") << shown(known.place) << " says nothing";
    }
}

/// Boxes with tables that scroll sideways, or all whose captions do not fit into the window.
constexpr const char* boxes_that_scroll = R"js([...document.querySelectorAll('.scroll:has(table)')]
  .filter(box => box.checkVisibility() && box.scrollWidth > box.clientWidth + 1))js";
constexpr const char* captions_cut_off = R"js([...document.querySelectorAll('caption:not(.hidden)')]
  .filter(e => e.checkVisibility() && (e.closest('.scroll').scrollLeft = 99, true))
  .filter(e => e.getBoundingClientRect().right > document.documentElement.clientWidth + 1 ||
               e.getBoundingClientRect().left < 0).map(e => e.textContent))js";

void unfold_and_draw_all(Page& page) {
  page.evaluate(
      "document.querySelectorAll('details').forEach(e => { e.open = true; });"
      "document.querySelectorAll('*').forEach(e => { e.style.contentVisibility = 'visible'; });"
      "new Promise(done => requestAnimationFrame(() => setTimeout(done, 100)))");
}

TEST_F(ReportInBrowserSlow, TablesFitOrScrollBelowTheirCaptions) {
  Page& page = opened();
  unfold_and_draw_all(page);
  EXPECT_THAT(page.texts(std::string(boxes_that_scroll) + ".map(e => e.textContent.slice(0, 60))"),
              testing::IsEmpty());
  page.set_size(narrow_width, narrow_height);
  unfold_and_draw_all(page);
  EXPECT_TRUE(page.holds(std::string(boxes_that_scroll) + ".length > 5"));
  EXPECT_THAT(page.texts(captions_cut_off), testing::IsEmpty());
  EXPECT_THAT(page.texts(std::string(boxes_that_scroll) +
                         ".filter(e => e.tabIndex !== 0 || e.getAttribute('role') !== 'region' ||"
                         " !e.getAttribute('aria-label')).map(e => e.outerHTML.slice(0, 200))"),
              testing::IsEmpty());
}

}  // namespace
}  // namespace phytobench
