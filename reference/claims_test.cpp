// SPDX-License-Identifier: MIT
#include "reference/claims.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

TEST(PublishedTables, PutCompanionsBesideTheMeasurement) {
  PublishedTable table;
  table.rows = {"voxel"};
  table.columns = {"s", "dn"};
  table.measurement = "p/t/{row}.{column}/seconds";
  EXPECT_EQ(table.measurement_at(0, 1), "p/t/voxel.dn/seconds");
  EXPECT_EQ(table.companion_at(0, 1, "queries"), "p/t/voxel.dn/queries");
}

TEST(Verdicts, HaveDistinctNames) {
  std::set<std::string_view> names;
  for (const Verdict verdict : all_verdicts) names.insert(name_of(verdict));
  EXPECT_EQ(names.size(), std::size(all_verdicts));
}

// Synthetic files.

/// A fresh folder for one test, removed afterwards.
class ClaimsFile : public testing::Test {
 protected:
  ClaimsFile()
      : folder_(fs::path(testing::TempDir()) /
                ("phytobench_claims_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ClaimsFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  std::string file() const { return (folder_ / "claims.toml").string(); }

  PaperClaims load(const std::string& text) const {
    write_file_atomically(file(), text);
    return load_claims_file(file(), "p");
  }

  std::string error_of(const std::string& text) const {
    try {
      load(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }

 private:
  fs::path folder_;
};

/// Lines 1 to 16: a claim, its check from line 12 on.
const std::string valid_claim = R"([[claim]]
id = "p/eq-1/count"
locator = "eq. 1"
kind = "count"
text = "Five."
published = "5"
basis = "paper"
tier = "quick"
expected_verdict = "reproduced"
predicted_verdict = "reproduced"
reason = "Counts are exact."
[[claim.check]]
of = "value"
terms = [["e/a"], ["e/b"]]
equals = 5
why = "exact"
)";

const std::string valid_table = R"([[table]]
id = "table-1"
title = "Times"
unit = "s"
row_labels = ["Slow", "Fast"]
column_labels = ["S", "D", "N"]
rows = ["slow", "fast"]
columns = ["s", "d", "n"]
measurement = "e/{row}.{column}/seconds"
values = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
origin = "published"
)";

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t place = text.find(old_part);
  EXPECT_NE(place, std::string::npos) << old_part;
  return place == std::string::npos ? text : text.replace(place, old_part.size(), new_part);
}

TEST_F(ClaimsFile, GivesWhatItSays) {
  const PaperClaims loaded = load(valid_claim + valid_table);
  ASSERT_EQ(loaded.claims.size(), 1u);
  const Claim& claim = loaded.claims[0];
  EXPECT_EQ(claim.id, "p/eq-1/count");
  EXPECT_EQ(claim.paper, "p");
  EXPECT_EQ(claim.kind, "count");
  EXPECT_EQ(claim.unit, "1");
  EXPECT_EQ(claim.basis, "paper");
  EXPECT_EQ(claim.tier, Tier::quick);
  EXPECT_EQ(claim.expected_verdict, Verdict::reproduced);
  EXPECT_FALSE(claim.digits.has_value());
  EXPECT_FALSE(claim.fixed_verdict.has_value());
  ASSERT_EQ(claim.checks.size(), 1u);
  const ClaimCheck& check = claim.checks[0];
  EXPECT_EQ(check.subject, CheckSubject::value);
  EXPECT_EQ(check.terms, (std::vector<std::vector<std::string>>{{"p/e/a"}, {"p/e/b"}}));
  EXPECT_EQ(check.equals.value_or(0.0), 5.0);
  EXPECT_FALSE(check.low.has_value());
  EXPECT_FALSE(check.high.has_value());
  EXPECT_EQ(check.required, 2u);
  EXPECT_EQ(check.why, "exact");
  ASSERT_EQ(loaded.tables.size(), 1u);
  EXPECT_EQ(loaded.tables[0].measurement_at(1, 2), "p/e/fast.n/seconds");
  EXPECT_EQ(loaded.tables[0].values[1][2], 6.0);
}

TEST_F(ClaimsFile, KeepsSignsInFrontOfThePaper) {
  const PaperClaims loaded = load(with(with(valid_claim, "\"value\"", "\"sum\""),
                                       R"([["e/a"], ["e/b"]])", R"([["+e/a", "-e/b"]])"));
  EXPECT_EQ(loaded.claims.at(0).checks.at(0).terms,
            (std::vector<std::vector<std::string>>{{"+p/e/a", "-p/e/b"}}));
}

TEST_F(ClaimsFile, MayHoldAFixedVerdictInsteadOfChecks) {
  const std::string head = valid_claim.substr(0, valid_claim.find("[[claim.check]]"));
  const PaperClaims loaded = load(head + "verdict = \"underspecified\"\n");
  EXPECT_EQ(loaded.claims.at(0).fixed_verdict, Verdict::underspecified);
  EXPECT_TRUE(loaded.claims.at(0).checks.empty());
}

TEST_F(ClaimsFile, SaysWhyAPredictionDidNotComeTrue) {
  const PaperClaims loaded = load(with(valid_claim, "predicted_verdict = \"reproduced\"",
                                       "predicted_verdict = \"not measured\"\n"
                                       "difference = \"It could be measured.\""));
  EXPECT_EQ(loaded.claims.at(0).predicted_verdict, Verdict::not_measured);
  EXPECT_EQ(loaded.claims.at(0).difference, "It could be measured.");
}

TEST_F(ClaimsFile, NamesTheMeasurementsOfASumWithoutTheirSigns) {
  const PaperClaims loaded = load(with(with(valid_claim, "\"value\"", "\"sum\""),
                                       R"([["e/a"], ["e/b"]])", R"([["+e/a", "-e/b"]])"));
  const ClaimCheck& check = loaded.claims.at(0).checks.at(0);
  EXPECT_EQ(measurement_of(check, check.terms[0][1]), "p/e/b");
  EXPECT_EQ(measurement_of({.subject = CheckSubject::value}, "p/e/b"), "p/e/b");
}

TEST_F(ClaimsFile, MustExist) {
  EXPECT_THROW(load_claims_file(file(), "p"), InputError);
}

TEST_F(ClaimsFile, RefusesAnIdThatStandsThereTwice) {
  // The second claim begins in line 17.
  const std::string error = error_of(valid_claim + valid_claim);
  EXPECT_THAT(error, StartsWith(file() + ":17: "));
  EXPECT_THAT(error, HasSubstr("p/eq-1/count"));
}

TEST_F(ClaimsFile, RefusesAClaimWithNeitherChecksNorVerdict) {
  const std::string head = valid_claim.substr(0, valid_claim.find("[[claim.check]]"));
  EXPECT_THAT(error_of(head), StartsWith(file() + ":1: "));
}

struct Mistake {
  std::string name;
  std::string old_part;
  std::string new_part;
  int line;           ///< where it is found
  std::string about;  ///< what the message must name
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class ClaimMistake : public ClaimsFile, public testing::WithParamInterface<Mistake> {};

TEST_P(ClaimMistake, IsAnInputErrorNamingFileAndLine) {
  const Mistake& mistake = GetParam();
  const std::string error = error_of(with(valid_claim, mistake.old_part, mistake.new_part));
  EXPECT_THAT(error, StartsWith(file() + ":" + std::to_string(mistake.line) + ": "));
  EXPECT_THAT(error, HasSubstr(mistake.about));
}

const std::string two_terms = R"([["e/a"], ["e/b"]])";

const std::vector<Mistake> claim_mistakes = {
    {"unknown_key", "locator", "locater", 3, "'locater'"},
    {"unknown_key_of_a_check", "equals", "equal", 15, "'equal'"},
    {"missing_key", "locator = \"eq. 1\"\n", "", 1, "'locator' is missing"},
    {"number_for_text", "\"eq. 1\"", "1", 3, "'locator' must be text"},
    {"unknown_kind", "kind = \"count\"", "kind = \"number\"", 1, "'kind' is 'number'"},
    {"unknown_basis", "basis = \"paper\"", "basis = \"hope\"", 1, "'basis' is 'hope'"},
    {"unknown_why", "why = \"exact\"", "why = \"taste\"", 12, "'why' is 'taste'"},
    {"unknown_subject", "of = \"value\"", "of = \"mean\"", 12, "'of' is 'mean'"},
    {"unknown_expected_verdict", "\"reproduced\"", "\"confirmed\"", 1, "'confirmed'"},
    {"unknown_fixed_verdict", "[[claim.check]]", "verdict = \"confirmed\"\n[[claim.check]]", 1,
     "'confirmed'"},
    {"no_predicted_verdict", "predicted_verdict = \"reproduced\"\n", "", 1,
     "'predicted_verdict' is missing"},
    {"unknown_predicted_verdict", "predicted_verdict = \"reproduced\"",
     "predicted_verdict = \"hoped for\"", 1, "'predicted_verdict' is 'hoped for'"},
    {"difference_that_is_not_said", "predicted_verdict = \"reproduced\"",
     "predicted_verdict = \"not reproduced\"", 1, "'difference' says why"},
    {"difference_that_is_none", "reason =", "difference = \"None.\"\nreason =", 1,
     "'difference' says why"},
    {"upper_case_id", "p/eq-1/count", "p/Eq-1/count", 1, "p/Eq-1/count"},
    {"id_of_another_paper", "p/eq-1/count", "q/eq-1/count", 1, "q/eq-1/count"},
    {"empty_reason", "Counts are exact.", "", 1, "reason"},
    {"check_without_bounds", "equals = 5\n", "", 12, "bounds"},
    {"check_without_terms", two_terms, "[]", 12, "terms"},
    {"terms_not_nested", two_terms, R"(["e/a", "e/b"])", 14, "'terms'"},
    {"bound_as_text", "equals = 5", "equals = \"5\"", 15, "'equals' must be a number"},
    {"two_measurements_of_a_value", two_terms, R"([["e/a", "e/b"]])", 12, "measurements"},
    {"no_measurement_of_a_value", two_terms, "[[]]", 12, "measurements"},
    {"one_measurement_of_a_ratio", "of = \"value\"", "of = \"ratio\"", 12, "measurements"},
    {"one_measurement_of_a_ratio_of_ratios", "of = \"value\"", "of = \"ratio-of-ratios\"", 12,
     "measurements"},
    {"one_measurement_of_a_sum", "of = \"value\"", "of = \"sum\"", 12, "measurements"},
    {"required_too_large", "equals = 5", "equals = 5\nrequired = 3", 12, "'required'"},
    {"required_zero", "equals = 5", "equals = 5\nrequired = 0", 12, "'required'"},
    {"both_checks_and_verdict", "[[claim.check]]", "verdict = \"not measured\"\n[[claim.check]]", 1,
     "either checks or a fixed verdict"},
    {"same_with_bounds", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]",
     "of = \"same\"\nterms = [[\"e/a\", \"e/b\"]]", 12, "bounds"},
    {"different_with_bounds", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]",
     "of = \"different\"\nterms = [[\"e/a\", \"e/b\"]]", 12, "bounds"},
    {"exponent_of_two_points", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]",
     "of = \"exponent\"\nterms = [[\"e/a\", \"e/b\", \"e/c\", \"e/d\"]]", 12, "measurements"},
    {"exponent_of_unpaired_values", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]",
     "of = \"exponent\"\nterms = [[\"e/a\", \"e/b\", \"e/c\", \"e/d\", \"e/f\", \"e/g\", \"e/h\"]]",
     12, "measurements"},
    {"accidents_of_a_value", "equals = 5", "equals = 5\naccident_steps = [4, 6]", 12,
     "'accident_steps'"},
    {"accidents_of_one_number", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]\nequals = 5",
     "of = \"matches\"\nterms = [[\"e/a\"]]\nequals_text = \"5\"\nlow = 1\naccident_steps = [4]",
     12, "'accident_steps'"},
    {"matches_without_text", "of = \"value\"", "of = \"matches\"", 12, "'matches' needs"},
    {"matches_without_bounds", "of = \"value\"\nterms = [[\"e/a\"], [\"e/b\"]]\nequals = 5",
     "of = \"matches\"\nterms = [[\"e/a\"]]\nequals_text = \"5\"", 12, "'matches' needs"},
    {"unknown_section", "[[claim]]", "other = 1\n[[claim]]", 1, "'other'"},
};

INSTANTIATE_TEST_SUITE_P(All, ClaimMistake, testing::ValuesIn(claim_mistakes),
                         [](const auto& test) { return test.param.name; });

class TableMistake : public ClaimsFile, public testing::WithParamInterface<Mistake> {};

TEST_P(TableMistake, IsAnInputErrorNamingFileAndLine) {
  const Mistake& mistake = GetParam();
  const std::string error = error_of(with(valid_table, mistake.old_part, mistake.new_part));
  EXPECT_THAT(error, StartsWith(file() + ":" + std::to_string(mistake.line) + ": "));
  EXPECT_THAT(error, HasSubstr(mistake.about));
}

const std::vector<Mistake> table_mistakes = {
    {"row_too_many", "[4.0, 5.0, 6.0]", "[4.0, 5.0, 6.0], [7.0, 8.0, 9.0]", 1, "fit"},
    {"row_missing", ", [4.0, 5.0, 6.0]", "", 1, "fit"},
    {"ragged_row", "[4.0, 5.0, 6.0]", "[4.0, 5.0]", 1, "fit"},
    {"row_label_missing", "\"Slow\", ", "", 1, "fit"},
    {"column_label_missing", "\"S\", ", "", 1, "fit"},
    {"value_as_text", "6.0", "\"6.0\"", 10, "'values'"},
    {"unknown_origin", "\"published\"", "\"guessed\"", 1, "'origin' is 'guessed'"},
    {"unknown_key", "title", "titel", 3, "'titel'"},
    {"measurement_missing", "measurement = \"e/{row}.{column}/seconds\"\n", "", 1,
     "'measurement' is missing"},
};

INSTANTIATE_TEST_SUITE_P(All, TableMistake, testing::ValuesIn(table_mistakes),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace phytobench
