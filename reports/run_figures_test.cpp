// SPDX-License-Identifier: MIT
#include "reports/run_figures.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reports/render_template.hpp"

namespace phytobench {
namespace {

TEST(SvgCaption, IsTheRootsLabelAndElseItsTitle) {
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\" aria-label=\"A\"><title>B</title></svg>"), "A");
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\">\n  <title>B</title></svg>"), "B");
  EXPECT_EQ(svg_caption("<?xml version=\"1.0\"?><svg aria-label=\"A\"/>"), "A");
}

TEST(SvgCaption, IsNotThatOfAPartInside) {
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\"><svg aria-label=\"part\"/></svg>"), "");
  EXPECT_EQ(svg_caption("<svg><g><title>part</title></g></svg>"), "");
  EXPECT_EQ(svg_caption("<svg"), "");
  EXPECT_EQ(svg_caption("no picture"), "");
}

TEST(SvgCaption, IsPlainTextOnceUnescaped) {
  EXPECT_EQ(svg_caption("<svg aria-label=\"a &lt; b &amp;amp; &quot;c&quot; > d\"/>"),
            "a < b &amp; \"c\" > d");
}

TEST(SvgDescription, IsTheRoots) {
  EXPECT_EQ(svg_description("<svg a=\"b\">\n<title id='a'>T</title>\n<desc id='b'>D &lt; E</desc>"),
            "D < E");
  EXPECT_EQ(svg_description("<svg><g><desc>part</desc></g></svg>"), "");
  EXPECT_EQ(svg_description("<svg><title>open"), "");
}

TEST(SvgWidth, IsThatOfTheViewBoxWhereLettersStand) {
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 366.0 330\"><text>x</text></svg>"), 366.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"-4 -1 8 3\"><text>x</text></svg>"), 8.0);
}

TEST(SvgWidth, IsNotTakenForPixelsInAPictureWithoutLetters) {
  EXPECT_GT(svg_width("<svg viewBox=\"-4 -1.6 8 3.4\"><g/></svg>"), 300.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 948 330\"><g/></svg>"), 948.0);
}

TEST(SvgWidth, IsZeroWithoutAUsableViewBox) {
  EXPECT_EQ(svg_width("<svg><svg viewBox=\"0 0 9 9\"/></svg>"), 0.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 wide 9\"><text/></svg>"), 0.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 -5 9\"><text/></svg>"), 0.0);
}

TEST(FigureOrder, FollowsTheNumbersAndThenTheNames) {
  const std::vector<std::string> ordered = {"p/z/figure-2.1.svg",
                                            "p/c/figure-4.7.svg",
                                            "p/c/figure-4.7-step-40.svg",
                                            "p/c/figure-4.7-step-100.svg",
                                            "p/b/figure-4.11.svg",
                                            "p/y/figures-7.6-7.7.svg",
                                            "p/x/figure-7.8.svg",
                                            "p/a/figure-10.svg",
                                            "p/a/figure-of-a-tree.svg",
                                            "p/a/growth-law-4.3.svg",
                                            "p/b/a.svg"};
  for (std::size_t i = 0; i < ordered.size(); ++i)
    for (std::size_t j = 0; j < ordered.size(); ++j)
      EXPECT_EQ(is_figure_before(ordered[i], ordered[j]), i < j) << ordered[i] << " " << ordered[j];
}

nlohmann::ordered_json figures_from(const std::map<std::string, std::string>& pictures,
                                    const std::map<std::string, std::string>& plot_data = {},
                                    const ClaimIndex& claims = {}) {
  return figures_of("p", {pictures, plot_data}, claims);
}

TEST(FiguresOf, KeepsToItsWorkAndFallsBackToTheName) {
  const auto figures = figures_from({{"p/e/b.svg", "<svg/>"},
                                     {"pp/e/c.svg", "<svg/>"},
                                     {"p/e/figure-1.svg",
                                      "<svg viewBox=\"0 0 400 9\" aria-label=\"One\"><text/>"
                                      "</svg>"}});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0]["caption"], "One");
  EXPECT_EQ(figures[0]["width"], "400");
  EXPECT_EQ(figures[0]["least_width"], "300");
  EXPECT_EQ(figures[1]["caption"], "B");
  EXPECT_EQ(figures[1]["least_width"], "0");
}

TEST(FiguresOf, LeadToTheClaimsAboutThem) {
  Claim claim;
  claim.id = "p/grows";
  claim.locator = "figures 4.6 and 4.7";
  const ClaimIndex claims({{.claim = &claim}}, false);
  const auto figures = figures_from(
      {{"p/e/figure-4.7-step-40.svg", "<svg/>"}, {"p/e/figure-4.8.svg", "<svg/>"}}, {}, claims);
  ASSERT_EQ(figures[0]["claims"].size(), 1u);
  EXPECT_EQ(figures[0]["claims"][0]["anchor"], "claim-p-grows");
  EXPECT_EQ(figures[1]["has_claims"], false);
  EXPECT_EQ(photographs_of("p", {{"p/e/figure-4.6-left.jpg", "x"}}, claims)[0]["has_claims"], true);
}

TEST(FiguresOf, KeepLargePicturesOutOfThePage) {
  const std::string large(61 * 1024, ' '), small(59 * 1024, ' ');
  const auto figures = figures_from({{"p/a.svg", "<svg>" + large}, {"p/b.svg", small}});
  EXPECT_EQ(figures[0]["in_page"], false);
  EXPECT_EQ(figures[0]["svg"], "");
  EXPECT_EQ(figures[0]["file"], "figures/p-a.svg");
  EXPECT_EQ(figures[1]["in_page"], true);
  const auto gallery = photographs_of("p", {{"p/a.jpg", large}, {"p/b.jpg", small}}, {});
  EXPECT_EQ(gallery[0]["source"], "");
  EXPECT_EQ(gallery[1]["in_page"], true);
}

TEST(FiguresOf, ShowTheNumbersBehindAPlotEvenWhereItWasNotDrawn) {
  const auto figures =
      figures_from({{"p/a.svg", "<svg><title id='t'>A</title><desc>It rises.</desc></svg>"}},
                   {{"p/a.csv", "x,y\n1,2\n"}, {"p/growth-law.csv", "x,y\n"}});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0]["caption"], "A");
  EXPECT_EQ(figures[0]["description"], "It rises.");
  EXPECT_EQ(figures[0]["data"]["file"], "figures/p-a.csv");
  EXPECT_EQ(figures[0]["data"]["rows"][0]["cells"][1], "2");
  EXPECT_EQ(figures[1]["name"], "p/growth-law.svg");
  EXPECT_EQ(figures[1]["caption"], "Growth law");
  EXPECT_EQ(figures[1]["has_picture"], false);
  EXPECT_EQ(figures[1]["data"]["has_rows"], false);
}

TEST(FiguresOf, HaveTheCaptionOfAPlotAlsoWhereItWasNotDrawn) {
  const std::map<std::string, std::string> pictures{{"p/a.svg", "<svg aria-label=\"Other\"/>"}},
      data{{"p/b.csv", "x,y\n"}};
  const auto figures = figures_of(
      "p", {pictures, data, {{"p/a.svg", {"A", "It rises."}}, {"p/b.svg", {"B", "It falls."}}}},
      {});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0]["caption"], "A");
  EXPECT_EQ(figures[1]["caption"], "B");
  EXPECT_EQ(figures[1]["description"], "It falls.");
  EXPECT_EQ(figures[1]["has_description"], true);
  EXPECT_EQ(figures[1]["has_picture"], false);
}

TEST(FiguresOf, SayThatAPlotWasNotDrawnInEveryFormat) {
  const std::map<std::string, std::string> pictures, data{{"p/growth-law.csv", "x,y\n"}};
  nlohmann::ordered_json document;
  document["has_pictures"] = true;
  document["pictures"] =
      figures_of("p", {pictures, data, {{"p/growth-law.svg", {"A law", "It falls."}}}}, {});
  for (const auto& [name, format] :
       {std::pair{"html", EscapeFor::html}, std::pair{"md", EscapeFor::markdown}}) {
    const std::string text =
        read_text_file(data_folder() / "templates" / name / "figures.mustache");
    const std::string page = render_template(text, document, format);
    EXPECT_NE(page.find("A law"), std::string::npos) << page;
    EXPECT_NE(page.find("It falls."), std::string::npos) << page;
    EXPECT_NE(page.find("(not drawn, for gnuplot is not installed)"), std::string::npos) << page;
  }
}

TEST(OwnIds, KeepReferencesWithWhatTheyName) {
  EXPECT_EQ(with_own_ids("<svg aria-labelledby=\"t d\"><title id='t'/><desc id='d'/>"
                         "<use href='#g'/></svg>",
                         "x"),
            "<svg aria-labelledby=\"x-t x-d\"><title id='x-t'/><desc id='x-d'/>"
            "<use href='#x-g'/></svg>");
}

TEST(OwnIds, AreThoseOfOnePictureAlone) {
  EXPECT_EQ(with_own_ids("<g id=\"a\" data-id=\"a\"/><p clip-path=\"url(#a)\"/>", "x"),
            "<g id=\"x-a\" data-id=\"a\"/><p clip-path=\"url(#x-a)\"/>");
}

}  // namespace
}  // namespace phytobench
