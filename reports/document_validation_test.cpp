// SPDX-License-Identifier: MIT
#include "reports/document_validation.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reports/render_template.hpp"

namespace phytobench {
namespace {

using nlohmann::ordered_json;

Validation example() {
  Validation validation;
  validation.certified = {{.set = "num_acc_4",
                           .statistic = "standard_deviation",
                           .function = "moments",
                           .certified = 0.1,
                           .computed = 0.1000000005,
                           .digits = 8.2,
                           .reachable = 8.2,
                           .is_unused = true},
                          {.set = "wampler_2",
                           .statistic = "coefficient",
                           .function = "polynomial_regression",
                           .answers = 6,
                           .certified = 0.001,
                           .computed = 0.001000000000000063,
                           .digits = 13.2},
                          {.set = "num_acc_4",
                           .statistic = "standard_deviation",
                           .function = "sums_of_squares",
                           .certified = 0.1,
                           .computed = 0.0,
                           .digits = 0.0,
                           .is_counter_example = true}};
  validation.ranks = {{.values = 7, .bootstrap = {{2, 6}, 0.875}, .other_ends = 0, .tried = 10}};
  validation.coverage = {{.statistic = "median",
                          .values = 9,
                          .law = "normal",
                          .method = "bootstrap",
                          .covered = 960,
                          .sets = 1000,
                          .share = {0.96, 0.945, 0.972}},
                         {.statistic = "median",
                          .values = 9,
                          .law = "autocorrelated",
                          .method = "bootstrap",
                          .covered = 820,
                          .sets = 1000,
                          .share = {0.82, 0.79, 0.85}}};
  validation.rounds = {{.experiment = "a/b", .series = 4, .median_correlation = 0.02}};
  return validation;
}

TEST(ValidationDocument, NamesTheWorstThatIsNoFaultOfTheData) {
  const ordered_json document = validation_document(example(), false);
  const auto summary = document["certified_summary"].get<std::string>();
  EXPECT_NE(summary.find("Of 6 answers of functions that"), std::string::npos) << summary;
  EXPECT_NE(summary.find("13.2 (Wampler2, coefficient)"), std::string::npos) << summary;
  EXPECT_EQ(document["certified"][0]["set"], "NumAcc4");
  EXPECT_EQ(document["certified"][0]["computed"], "0.1000000005");
  EXPECT_NE(summary.find("1 more answer is of functions that nothing else"), std::string::npos);
  EXPECT_EQ(document["certified"][0]["unused"], true);
  EXPECT_EQ(document["certified"][1]["unused"], false);
  EXPECT_EQ(document["certified"][2]["unused"], true);
}

TEST(ValidationDocument, SaysInWordsWhereIntervalsHoldTooFew) {
  const ordered_json document = validation_document(example(), false);
  EXPECT_EQ(document["ranks"][0]["too_few"], true);
  const ordered_json& grid = document["grids"][0];
  EXPECT_EQ(grid["columns"], (ordered_json{"normal", "autocorrelated"}));
  ASSERT_EQ(grid["rows"].size(), 1u);
  EXPECT_EQ(grid["rows"][0]["label"], "median of 9, bootstrap");
  EXPECT_EQ(grid["rows"][0]["cells"][0]["text"], "96.0 %");
  EXPECT_EQ(grid["rows"][0]["cells"][1]["text"], "82.0 % (too few)");
}

TEST(ValidationDocument, LeavesOutTimesOnRequest) {
  EXPECT_TRUE(validation_document(example(), false)["has_rounds"].get<bool>());
  EXPECT_FALSE(validation_document(example(), true)["has_rounds"].get<bool>());
}

TEST(ValidationDocument, FillsBothTemplates) {
  ordered_json document;
  document["validation"] = validation_document(example(), false);
  for (const auto& [format, folder] :
       {std::pair{EscapeFor::html, "html"}, {EscapeFor::markdown, "md"}}) {
    const auto read = [&](const std::string& name) {
      return read_text_file(data_folder() / "templates" / folder / (name + ".mustache"));
    };
    const Partials parts{{"grids", read("grids")}, {"grid", read("grid")}};
    const std::string text =
        render_template(with_partials(read("validation"), parts), document, format);
    for (const char* expected : {"NumAcc4", "13.2", "82.0 % (too few)", "none exists", "not used"})
      EXPECT_NE(text.find(expected), std::string::npos) << folder << ": " << expected;
    EXPECT_EQ(text.find("{{"), std::string::npos) << folder;
  }
}

}  // namespace
}  // namespace phytobench
