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
    comparison.records.differing = {
        {.measurement = "p/e/x_y", .values = {"1", std::nullopt}, .relative = 0.25}};
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
  EXPECT_EQ(document["contradicted"][0]["cells"][1]["run"], "Clang on X");
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

TEST(ComparisonDocument, SaysWhereRunsComeFromAndWhatOfItDiffers) {
  TwoRuns runs;
  const auto fact = [&](const std::string& name) {
    const ordered_json document = runs.document();
    for (const ordered_json& row : document["facts"])
      if (row["name"] == name) return row;
    return ordered_json();
  };
  EXPECT_EQ(fact("compiler")["cells"], (ordered_json{"GNU 12", "Clang"}));
  EXPECT_EQ(fact("compiler")["differs"], true);
  EXPECT_EQ(fact("processor")["cells"], (ordered_json{"not recorded", "not recorded"}));
  EXPECT_EQ(fact("tier")["differs"], false);
  EXPECT_TRUE(runs.document()["notes"].empty());
  runs.comparison.runs[1].contents.header = {Tier::full, 7};
  EXPECT_EQ(fact("tier")["differs"], true);
  EXPECT_EQ(runs.document()["notes"].size(), 2u) << "tier and seed";
}

TEST(ComparisonDocument, NamesTheFirstDifferingRecordsAndCountsTheRest) {
  TwoRuns runs;
  EXPECT_EQ(runs.document()["records"]["has_more"], false);
  const DifferingRecord one = runs.comparison.records.differing[0];
  runs.comparison.records.differing.assign(25, one);
  const ordered_json records = runs.document()["records"];
  EXPECT_EQ(records["differing"], 25);
  EXPECT_EQ(records["first"].size(), 20u);
  EXPECT_EQ(records["more"], 5);
  EXPECT_EQ(records["first"][0]["cells"], (ordered_json{"1", "-"}));
  EXPECT_EQ(records["first"][0]["relative"], "0.25");
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
  for (const char* part : {"id=\"comparison\"", "2 runs side by side", "A claim &lt;on&gt; things",
                           "<th scope=\"row\">Clang on X</th>", "<code>p/e/x_y</code>", "1 differ",
                           "1 are in GCC on X alone", "2.1 [2.0, 2.2]"})
    EXPECT_THAT(html, HasSubstr(part));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
}

TEST(ComparisonTemplate, SaysItInMarkdown) {
  const std::string text = TwoRuns().rendered("md/comparison.mustache", EscapeFor::markdown);
  for (const char* part :
       {"## 2 runs side by side", "  - Clang on X: **not reproduced**, measured 6",
        "| p/e/x\\_y | 1 | - | 0.25 |", "**1 differ**", "| compiler (differs) | GNU 12 | Clang |"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, Not(HasSubstr("{{")));
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
