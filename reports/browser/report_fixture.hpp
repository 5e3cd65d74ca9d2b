// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/text_file.hpp"
#include "reports/browser/browser_fixture.hpp"
#include "reports/browser/report_under_test.hpp"
#include "reports/document_anchors.hpp"
#include "reports/document_locators.hpp"

namespace phytobench {

inline constexpr int narrow_width = 360, narrow_height = 740;  ///< pixels, of a small phone

/// Anchors of claims, sorted.
using Anchors = std::vector<std::string>;

/// A text as a literal of JavaScript.
inline std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump();
}

/// A section has the places of those inside it, too.
inline bool has_place(const nlohmann::json& claim, const Place& place) {
  const std::vector<Place> places = places_of(claim["locator"].get<std::string>());
  return std::any_of(places.begin(), places.end(), [&](const Place& own) {
    return own == place || (place.kind == PlaceKind::section && own.kind == place.kind &&
                            own.number.starts_with(place.number + "."));
  });
}

inline bool is_of(const nlohmann::json& claim, const std::string& paper) {
  return claim["id"].get<std::string>().starts_with(paper + "/");
}

/// The claim is open, its first line lies in the window, and nothing lies on it.
inline std::string is_revealed(const std::string& anchor) {
  return fmt::format(R"js((() => {{
    const claim = document.getElementById({}).closest('details.claim');
    const box = claim.querySelector('summary .badge').getBoundingClientRect();
    const hit = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
    return claim.open && hit && hit.closest('details.claim') === claim;
  }})())js",
                     quoted(anchor));
}

/// A report in a browser, the same for all tests of the suite.
class ReportInBrowserSlow : public BrowserSlow {
 protected:
  static void SetUpTestSuite() {
    BrowserSlow::SetUpTestSuite();
    if (!browser_) return;
    make_report_under_test(folder_);
    claims_ = nlohmann::json::parse(read_text_file(report() / "verdicts.json"))["claims"];
    page_ = std::make_unique<Page>(*browser_);
  }

  static void TearDownTestSuite() {
    page_.reset();
    BrowserSlow::TearDownTestSuite();
  }

  void SetUp() override {
    BrowserSlow::SetUp();
    if (page_) page_->reset();
  }

  static std::filesystem::path report() { return folder_ / "report"; }

  /// The report, loaded anew.
  static Page& opened(const std::string& fragment = "") {
    is_as_loaded_ = false;
    page_->open(report() / "index.html", fragment);
    return *page_;
  }

  /// The report for a test that changes nothing in it: neighbours share it.
  static Page& as_loaded() {
    if (!is_as_loaded_) opened();
    is_as_loaded_ = true;
    return *page_;
  }

  static Anchors claims_that(const std::function<bool(const nlohmann::json&)>& condition) {
    Anchors anchors;
    for (const nlohmann::json& claim : claims_)
      if (condition(claim)) anchors.push_back(claim_anchor(claim["id"].get<std::string>()));
    std::sort(anchors.begin(), anchors.end());
    return anchors;
  }

  static Anchors all_claims() {
    return claims_that([](const nlohmann::json&) { return true; });
  }

  /// Those whose line can be seen, be it after scrolling.
  static Anchors shown_claims() {
    Anchors anchors = page_->texts(
        "[...document.querySelectorAll('details.claim')].filter(e => e.checkVisibility())"
        ".map(e => e.querySelector('[id^=claim-]').id)");
    std::sort(anchors.begin(), anchors.end());
    return anchors;
  }

  static inline std::unique_ptr<Page> page_;
  static inline bool is_as_loaded_ = false;
  static inline nlohmann::json claims_;
};

}  // namespace phytobench
