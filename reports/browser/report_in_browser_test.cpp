// SPDX-License-Identifier: MIT
// The report as a reader gets it: loaded from a file, without a network, on a wide and on a narrow
// screen, in the light and in the dark, on paper, without scripts, and without eyes.
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/image.hpp"
#include "reports/browser/accessibility_checks.hpp"
#include "reports/browser/page_checks.hpp"
#include "reports/browser/report_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

constexpr std::uintmax_t most_bytes = 5'000'000;
constexpr std::size_t most_elements_per_claim = 90;  ///< a page grows with the works it judges

void unfold_all(Page& page) {
  page.evaluate("document.querySelectorAll('details').forEach(e => { e.open = true; })");
}

TEST_F(ReportInBrowserSlow, LoadsWithoutAComplaintOrARequest) {
  Page& page = opened();
  EXPECT_EQ(page.requests().size(), 1u) << "the file itself";
  unfold_all(page);
  page.evaluate("window.scrollTo(0, document.documentElement.scrollHeight)");
  page.evaluate("new Promise(done => requestAnimationFrame(() => setTimeout(done, 0)))");
  EXPECT_THAT(loading_problems(page), IsEmpty());
}

TEST_F(ReportInBrowserSlow, IsSmallEnoughToBeUsedAtOnce) {
  Page& page = as_loaded();
  EXPECT_LT(fs::file_size(report() / "index.html"), most_bytes);
  EXPECT_LT(page.evaluate("document.querySelectorAll('*').length"),
            most_elements_per_claim * claims_.size());
  std::cout << "from the start of loading until it can be used: "
            << page.evaluate("performance.timing.domInteractive - performance.timing.fetchStart")
            << " ms, until all is loaded: "
            << page.evaluate("performance.timing.loadEventStart - performance.timing.fetchStart")
            << " ms\n";
}

TEST_F(ReportInBrowserSlow, EveryLinkLeadsSomewhere) {
  EXPECT_THAT(link_problems(as_loaded(), report()), IsEmpty());
}

TEST_F(ReportInBrowserSlow, EveryTextStandsOutFromItsGround) {
  Page& page = as_loaded();
  EXPECT_GT(ground_luminance(page), 0.8);
  EXPECT_THAT(contrast_problems(page), IsEmpty());
  page.set_color_scheme("dark");
  EXPECT_LT(ground_luminance(page), 0.05);
  EXPECT_THAT(contrast_problems(page), IsEmpty());
}

TEST_F(ReportInBrowserSlow, CanBeUsedWithoutEyes) {
  Page& page = as_loaded();
  EXPECT_THAT(name_problems(page), IsEmpty());
  EXPECT_THAT(accessibility_problems(page), IsEmpty());
  EXPECT_EQ(page.evaluate("document.documentElement.lang"), "en");
  EXPECT_TRUE(page.holds("document.getElementById('shown').getAttribute('aria-live')"));
}

TEST_F(ReportInBrowserSlow, CanBePrinted) {
  Page& page = as_loaded();
  page.set_medium("print");
  EXPECT_TRUE(
      page.holds("[...document.querySelectorAll('details.claim .facts')].every(e =>"
                 " e.checkVisibility() && e.getBoundingClientRect().height > 0)"));
  EXPECT_FALSE(page.holds("document.getElementById('filter').checkVisibility()"));
  EXPECT_THAT(contrast_problems(page), IsEmpty());
}

TEST_F(ReportInBrowserSlow, CanBeReadWithoutScripts) {
  page_->set_scripts(false);
  Page& page = opened();
  EXPECT_EQ(shown_claims(), all_claims());
  EXPECT_TRUE(
      page.holds("[...document.querySelectorAll('details.claim')].every(e =>"
                 " e.querySelector('.facts').textContent.includes('Reason'))"));
  EXPECT_FALSE(page.holds("document.getElementById('filter').checkVisibility()"));
  EXPECT_TRUE(
      page.holds("[...document.querySelectorAll('button')].every(e =>"
                 " !e.checkVisibility())"));
  page.click("document.querySelector('details.claim summary')");
  EXPECT_TRUE(page.holds("document.querySelector('details.claim .facts').checkVisibility()"));
}

void expect_fits(Page& page) {
  EXPECT_THAT(width_problems(page), IsEmpty());
  EXPECT_THAT(target_problems(page, ".bar"), IsEmpty());
  unfold_all(page);
  EXPECT_THAT(width_problems(page), IsEmpty()) << "all unfolded";
  EXPECT_THAT(target_problems(page, ".bar"), IsEmpty()) << "all unfolded";
}

TEST_F(ReportInBrowserSlow, FitsAWideWindow) {
  expect_fits(opened());
}

TEST_F(ReportInBrowserSlow, FitsANarrowWindow) {
  page_->set_size(narrow_width, narrow_height);
  expect_fits(opened());
}

/// The mean over its pixels, 0 to 1.
double lightness(const Image& image) {
  double sum = 0.0;
  for (const Pixel& pixel : image.pixels()) sum += pixel[0] + pixel[1] + pixel[2];
  return sum / (3.0 * 255.0 * static_cast<double>(image.pixels().size()));
}

/// A picture of the report's top, which is also kept to be looked at.
Image screenshot(Page& page, const std::string& name) {
  const std::string png = page.screenshot();
  write_file_atomically(fs::path(testing::TempDir()) / "phytobench-screenshots" / (name + ".png"),
                        png);
  return parse_png(png, name);
}

void expect_light_and_dark(Page& page, const std::string& window) {
  page.set_color_scheme("dark");
  EXPECT_LT(lightness(screenshot(page, window + "-dark")), 0.3);
  page.set_color_scheme("light");
  EXPECT_GT(lightness(screenshot(page, window + "-light")), 0.7);
}

TEST_F(ReportInBrowserSlow, IsLightAndDarkAsTheReaderWants) {
  expect_light_and_dark(opened(), "wide");
  page_->set_size(narrow_width, narrow_height);
  expect_light_and_dark(opened(), "narrow");
}

/// Whether the element that has the focus lies in the window with a frame around it.
constexpr const char* focus_can_be_seen = R"js((() => {
  const box = document.activeElement.getBoundingClientRect();
  const style = getComputedStyle(document.activeElement);
  return box.width > 0 && box.left >= 0 && box.top >= 0 && box.bottom <= innerHeight &&
         style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2;
})())js";

TEST_F(ReportInBrowserSlow, CanBeUsedByKeyboard) {
  Page& page = opened();
  page.press("Tab");
  EXPECT_TRUE(page.holds("document.activeElement.matches('a.skip')"));
  EXPECT_TRUE(page.holds(focus_can_be_seen));
  page.press("Tab");
  EXPECT_EQ(page.evaluate("document.activeElement.name"), "q") << "the search field";
  EXPECT_TRUE(page.holds(focus_can_be_seen));
  for (int key = 0; key < 20; ++key) {
    page.press("Tab");
    EXPECT_TRUE(page.holds(focus_can_be_seen))
        << page.evaluate("document.activeElement.outerHTML.slice(0, 120)");
  }
  page.evaluate("document.querySelector('details.claim summary').focus()");
  page.press("Enter");
  EXPECT_TRUE(page.holds("document.querySelector('details.claim').open"));
}

TEST_F(ReportInBrowserSlow, TheSkipLinkLeadsToTheReport) {
  Page& page = opened();
  page.press("Tab");
  page.press("Enter");
  page.wait_until("location.hash === '#main'");
  page.press("Tab");
  EXPECT_TRUE(page.holds("document.activeElement.closest('main')"));
}

TEST_F(ReportInBrowserSlow, BecomesPagesAndIsFoldedAfterwardsAsBefore) {
  Page& page = opened("#?verdict=failures");  // all of it takes many seconds
  EXPECT_TRUE(page.print_to_pdf("1-2").starts_with("%PDF-"));
  EXPECT_FALSE(page.holds("document.querySelector('details.claim[open]')"));
}

}  // namespace
}  // namespace phytobench
