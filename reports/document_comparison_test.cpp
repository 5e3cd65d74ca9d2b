// SPDX-License-Identifier: MIT
#include "reports/document_comparison.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reports/render_template.hpp"

namespace phytobench {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

/// Two runs that decide one claim differently, and another, on times, alike.
struct TwoRuns {
  JudgedRun merged;
  RunComparison comparison;
  std::vector<std::string> environments = {R"({"compiler": "GNU 12"})", R"({"compiler": "Clang"})"};

  TwoRuns() {
    merged.papers.resize(1);
    JudgedPaper& paper = merged.papers[0];
    paper.claims.claims.resize(2);
    for (const char* name : {"p/count", "p/ratio"}) {
      Claim& claim = paper.claims.claims[paper.judgements.size()];
      claim.id = name;
      claim.text = "A claim <on> things";
      paper.judgements.push_back({.claim = &claim, .verdict = Verdict::inconclusive});
    }
    paper.judgements[1].varies = true;
    comparison.runs = {{"GCC on X", {}}, {"Clang on X", {}}};
    comparison.claims = {{.id = "p/count",
                          .verdicts = {Verdict::reproduced, Verdict::not_reproduced},
                          .measured = {"5", "6"},
                          .merged = Verdict::inconclusive,
                          .contradicted = true},
                         {.id = "p/ratio",
                          .verdicts = {Verdict::reproduced, Verdict::inconclusive},
                          .measured = {"2.1 [2.0, 2.2]", "1.9 [1.0, 2.8]"},
                          .merged = Verdict::reproduced,
                          .varies = true}};
    comparison.records = {.in_all = 5, .shared = 6, .equal = 5, .differing = {}, .only_in = {1, 0}};
    comparison.records.differing = {{"p/e", "p/e/x_y", {"1", std::nullopt}, 0.25}};
    comparison.records.shared_of = {{"p/e", 6}};
  }

  ordered_json document(bool without_varying = false) const {
    return comparison_document(merged, comparison, environments, without_varying);
  }

  std::string rendered(const char* name, EscapeFor format) const {
    ordered_json document;
    document["comparison"] = this->document();
    return render_template(read_text_file(data_folder() / "templates" / name), document, format);
  }
};

TEST(ComparisonDocument, NamesWhatRunsDecideDifferently) {
  const ordered_json document = TwoRuns().document();
  ASSERT_EQ(document["contradicted"].size(), 1u);
  EXPECT_EQ(document["contradicted"][0]["id"], "p/count");
  EXPECT_EQ(document["contradicted"][0]["cells"][1]["run"], "B");
  EXPECT_EQ(document["contradicted"][0]["cells"][1]["verdict"], "not reproduced");
  EXPECT_EQ(document["decided_by_all"], 1);
  EXPECT_EQ(document["decided_by_some"], 1);
}

TEST(ComparisonDocument, CountsVerdictsOfEachRunAndMerged) {
  const ordered_json document = TwoRuns().document();
  for (const ordered_json& row : document["verdicts"])
    if (row["verdict"] == "reproduced") {
      EXPECT_EQ(row["cells"], (ordered_json{2, 0}));
      EXPECT_EQ(row["merged"], 1);
    }
}

TEST(ComparisonDocument, ShowsClaimsOnTimesRunByRun) {
  const ordered_json document = TwoRuns().document();
  ASSERT_EQ(document["timings"].size(), 1u);
  EXPECT_EQ(document["timings"][0]["cells"][1]["measured"], "1.9 [1.0, 2.8]");
}

TEST(ComparisonDocument, CallsRunsByLettersAndSaysWhatTheyAre) {
  TwoRuns runs;
  runs.comparison.runs[0].folder = "results/a";
  const ordered_json document = runs.document();
  EXPECT_EQ(document["labels"], (ordered_json{"A", "B"}));
  EXPECT_EQ(document["facts"][0]["cells"], (ordered_json{"GCC on X", "Clang on X"}));
}

TEST(ComparisonDocument, SaysNothingPublishedWhereNothingIs) {
  TwoRuns runs;
  EXPECT_EQ(runs.document()["contradicted"][0]["has_published"], false);
  EXPECT_THAT(runs.rendered("html/comparison.mustache", EscapeFor::html),
              Not(HasSubstr("Published: ")));
  runs.merged.papers[0].claims.claims[0].published = "4";
  runs.merged.papers[0].claims.claims[0].unit = "m";
  for (const auto& [name, format] : {std::pair{"html/comparison.mustache", EscapeFor::html},
                                     std::pair{"md/comparison.mustache", EscapeFor::markdown}})
    EXPECT_THAT(runs.rendered(name, format), HasSubstr("Published: 4 m."));
}

TEST(ComparisonDocument, HoldsNoTimeAndNoMachineWhenWhatVariesIsLeftOut) {
  const ordered_json document = TwoRuns().document(true);
  EXPECT_TRUE(document["timings"].empty());
  for (const char* varying : {"2.1", "GNU", "processor", "samples"})
    EXPECT_THAT(document.dump(), Not(HasSubstr(varying)));
  EXPECT_EQ(document["contradicted"].size(), 1u) << "counts are no times";
  EXPECT_EQ(document["decided_by_some"], 0);
}

TEST(ComparisonTemplate, SaysItInHtml) {
  const std::string html = TwoRuns().rendered("html/comparison.mustache", EscapeFor::html);
  for (const char* part :
       {"id=\"comparison\"", "2 runs side by side", "A claim &lt;on&gt; things",
        "<th scope=\"row\">B", "<code>x_y</code>", "<td>Clang on X", "<td colspan=\"2\">quick",
        "2.1 [2.0, 2.2]", "1 differs; the other", "<summary><code>p/e</code>: 1 of 6 differ"})
    EXPECT_THAT(html, HasSubstr(part));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
}

TEST(ComparisonTemplate, SaysItInMarkdown) {
  const std::string text = TwoRuns().rendered("md/comparison.mustache", EscapeFor::markdown);
  for (const char* part : {"## 2 runs side by side", "  - B: **not reproduced**, measured 6",
                           "#### p/e: 1 of 6 differ", "| x\\_y | 1 | - | 0.25 |",
                           "**1 differs; the other", "| compiler (differs) | GNU 12 | Clang |"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, Not(HasSubstr("{{")));
}

TEST(ComparisonTemplate, BeginsWithItsWarnings) {
  TwoRuns runs;
  runs.comparison.runs[1].contents.header.seed = 7;
  for (const auto& [name, format] : {std::pair{"html/comparison.mustache", EscapeFor::html},
                                     std::pair{"md/comparison.mustache", EscapeFor::markdown}}) {
    const std::string text = runs.rendered(name, format);
    const std::size_t warning = text.find("The runs have different seeds");
    ASSERT_NE(warning, std::string::npos) << name;
    EXPECT_LT(warning, text.find("Each run was judged alone")) << name;
  }
}

TEST(ComparisonTemplate, SaysNothingOfASingleRun) {
  ordered_json document;
  document["has_comparison"] = false;
  for (const char* name : {"html/comparison.mustache", "md/comparison.mustache"}) {
    const std::string text = render_template(read_text_file(data_folder() / "templates" / name),
                                             document, EscapeFor::html);
    EXPECT_EQ(text.find_first_not_of(" \n"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace phytobench
