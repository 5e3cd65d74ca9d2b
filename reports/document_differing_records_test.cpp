// SPDX-License-Identifier: MIT
#include "reports/document_differing_records.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

using nlohmann::ordered_json;

RunComparison comparison_of(std::size_t runs, const RecordComparison& records) {
  RunComparison comparison;
  comparison.runs.resize(runs);
  comparison.records = records;
  return comparison;
}

TEST(DifferingRecords, AreSaidInSentences) {
  const ordered_json equal = differing_records_document(
      comparison_of(2, {.in_all = 8, .shared = 8, .equal = 8, .differing = {}, .only_in = {5, 7}}));
  EXPECT_EQ(equal["shared_text"], "Both runs have 8 measurements in common.");
  EXPECT_EQ(equal["equal_text"], "None differs: all are equal, bit for bit.");
  EXPECT_EQ(equal["only_text"], "Found in one run alone: 5 in A, 7 in B.");
  EXPECT_EQ(equal["has_differing"], false);
  const ordered_json three = differing_records_document(
      comparison_of(3, {.in_all = 1,
                        .shared = 3,
                        .equal = 2,
                        .differing = {{"p/e", "p/e/x", {"1", "2", std::nullopt}, 0.5}},
                        .only_in = {0, 0, 0}}));
  EXPECT_EQ(three["shared_text"],
            "All 3 runs have 1 measurement in common and some of them 2 more.");
  EXPECT_EQ(three["equal_text"], "1 differs; the other 2 are equal, bit for bit.");
  EXPECT_EQ(three["only_text"], "");
}

TEST(DifferingRecords, ClaimNothingOfRunsThatShareNothing) {
  const ordered_json document = differing_records_document(
      comparison_of(2, {.in_all = 0, .shared = 0, .equal = 0, .differing = {}, .only_in = {5, 0}}));
  EXPECT_EQ(document["equal_text"], "");
  EXPECT_EQ(document["only_text"], "Found in one run alone: 5 in A.");
}

TEST(DifferingRecords, StandByExperimentWithTheFirstTenOfEach) {
  RecordComparison records{.in_all = 40, .shared = 40, .equal = 15, .differing = {}, .only_in = {}};
  records.differing.assign(24, {"p/e", "p/e/x", {"1", std::nullopt}, 0.25});
  records.differing.push_back({"q/f", "text", {"a", "b"}, std::nullopt});
  records.shared_of = {{"p/e", 30}, {"q/f", 10}};
  const ordered_json document = differing_records_document(comparison_of(2, records));
  EXPECT_EQ(document["differing"], 25);
  ASSERT_EQ(document["experiments"].size(), 2u);
  const ordered_json& first = document["experiments"][0];
  EXPECT_EQ(first["experiment"], "p/e");
  EXPECT_EQ(first["differing"], 24);
  EXPECT_EQ(first["shared"], 30);
  EXPECT_EQ(first["largest"], "0.25");
  EXPECT_EQ(first["rows"].size(), 10u);
  EXPECT_EQ(first["more"], 14);
  EXPECT_EQ(first["rows"][0]["measurement"], "x");
  EXPECT_EQ(first["rows"][0]["cells"], (ordered_json{"1", "-"}));
  const ordered_json& second = document["experiments"][1];
  EXPECT_EQ(second["has_largest"], false);
  EXPECT_EQ(second["rows"][0]["measurement"], "text");
  EXPECT_EQ(second["rows"][0]["relative"], "-");
  EXPECT_EQ(second["has_more"], false);
}

}  // namespace
}  // namespace phytobench
