// SPDX-License-Identifier: MIT
// The pages as readers get them: all claims of all papers through the real templates.
#include <regex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference/data_folder.hpp"
#include "reports/document.hpp"
#include "reports/render_template.hpp"

namespace phytobench {
namespace {

std::multiset<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::multiset<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

RunContents run_with_times(double factor) {
  RunContents run;
  run.header = {Tier::quick, 0};
  run.complete_experiments = {"brzoska2019/growth-time"};
  for (std::int64_t round = 0; round < 4; ++round)
    run.timings.push_back({.experiment = "brzoska2019/growth-time",
                           .measurement = "brzoska2019/growth-time/a/seconds",
                           .round = round,
                           .value = factor * static_cast<double>(round + 1)});
  return run;
}

nlohmann::ordered_json document_of(const RunContents& run, bool without_varying) {
  const JudgedRun judged = judge_run(run);
  const std::string svg = "<svg id=\"s\" viewBox=\"0 0 9 9\"><title>Drawn</title></svg>";
  const DocumentSources sources{
      .environment_json = R"({"compiler": "GNU", "date_utc": "today"})",
      .run_folder = "here",
      .pictures = {{"alsweis/x/figure-4.7.svg", svg}, {"alsweis/y/figure-4.7.svg", svg}},
      .photographs = {{"brzoska2019/x/figure-40-left.jpg", "jpeg"}},
      .plots = {},
      .without_varying = without_varying};
  return make_document(judged, sources);
}

std::string page(EscapeFor format) {
  return render_report(data_folder() / "templates", document_of(run_with_times(1.0), false),
                       format);
}

const std::string& html() {
  static const std::string text = page(EscapeFor::html);
  return text;
}

TEST(HtmlPage, HasEveryPlaceThatItLinksTo) {
  const auto ids = all_matches(html(), " id=\"([^\"]*)\"");
  const auto links = all_matches(html(), " href=\"#([^\"]*)\"");
  EXPECT_GT(links.size(), 1000u);
  for (const std::string& link : std::set<std::string>(links.begin(), links.end()))
    EXPECT_TRUE(ids.contains(link)) << link;
}

TEST(HtmlPage, NamesNoPlaceTwice) {
  const auto ids = all_matches(html(), " id=\"([^\"]*)\"");
  for (const std::string& id : ids) EXPECT_EQ(ids.count(id), 1u) << id;
}

TEST(HtmlPage, AsksForNothingOutsideItself) {
  EXPECT_TRUE(all_matches(html(), "(?:src|href)=\"((?:https?:)?//[^\"]*)\"").empty());
  EXPECT_EQ(html().find("url(http"), std::string::npos);
  EXPECT_EQ(html().find("<link"), std::string::npos);
  EXPECT_EQ(html().find("@import"), std::string::npos);
}

TEST(HtmlPage, GivesEveryTableACaption) {
  EXPECT_EQ(all_matches(html(), "(<table[ >])").size(),
            all_matches(html(), "(<table[^>]*><caption)").size());
}

TEST(HtmlPage, LeavesNoTagOfTheTemplatesBehind) {
  EXPECT_EQ(html().find("{{"), std::string::npos);
  EXPECT_NE(html().find("</html>"), std::string::npos);
}

TEST(DocumentModel, DoesNotVaryWhereNothingMay) {
  EXPECT_EQ(document_of(run_with_times(1.0), true), document_of(run_with_times(3.0), true));
  EXPECT_NE(document_of(run_with_times(1.0), false), document_of(run_with_times(3.0), false));
}

TEST(MarkdownPage, HasEveryPlaceThatItLinksTo) {
  const std::string text = page(EscapeFor::markdown);
  const auto anchors = all_matches(text, "<a id=\"([^\"]*)\"");
  const auto links = all_matches(text, "\\]\\(#([^)]*)\\)");
  EXPECT_GT(links.size(), 500u);
  for (const std::string& link : std::set<std::string>(links.begin(), links.end()))
    EXPECT_TRUE(anchors.contains(link)) << link;
  EXPECT_EQ(text.find("{{"), std::string::npos);
}

}  // namespace
}  // namespace phytobench
