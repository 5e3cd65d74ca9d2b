// SPDX-License-Identifier: MIT
#include "reports/judge/fulfilled_claim.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/judge/claim_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(MeasurementsOfAClaim, AreThoseItNamesAndTheRunHas) {
  const Claim claim = claim_of({check_of(CheckSubject::sum, {{"+p/a", "-p/b"}, {"+p/t", "-p/c"}})});
  std::vector<TimingSample> times;
  for (const double seconds : {1.0, 7.0, 3.0})
    times.push_back(
        {.measurement = "p/t", .round = static_cast<std::int64_t>(times.size()), .value = seconds});
  const Evidence evidence = evidence_of({{.measurement = "p/a", .value = std::int64_t{5}},
                                         {.measurement = "p/d", .value = std::int64_t{6}}},
                                        times);
  EXPECT_THAT(
      measurements_of(claim, evidence),
      ElementsAre(Pair("p/a", RecordValue(std::int64_t{5})), Pair("p/t", RecordValue(3.0))));
}

TEST(MeasurementsOfAClaim, OfCountedOnesAreTheMatchesAndOneOther) {
  ClaimCheck check = at_least(1.0, check_of(CheckSubject::matches, {{"p/seeds/"}}));
  check.equals_text = "wanted";
  std::vector<Record> records;
  for (const char* text : {"no", "wanted", "never", "nor this", "wanted"})
    records.push_back(
        {.measurement = "p/seeds/" + std::to_string(records.size()), .value = std::string(text)});
  const Measurements kept = measurements_of(claim_of({check}), evidence_of(records));
  EXPECT_EQ(kept.size(), 3u);
  EXPECT_TRUE(holds(claim_of({check}), kept));
}

TEST(FulfilledClaim, KeepsWhatAlreadyHolds) {
  const Claim claim = claim_of({at_least(1.0, check_of(CheckSubject::value, {{"m"}}))});
  const Measurements two = {{"m", 2.0}};
  EXPECT_EQ(fulfilled(claim, two), two);
}

TEST(FulfilledClaim, MakesUpWhatIsMissingForEverySubject) {
  ClaimCheck text = check_of(CheckSubject::value, {{"text"}});
  text.equals_text = "a b";
  ClaimCheck matches = at_least(2.0, check_of(CheckSubject::matches, {{"counted/"}}));
  matches.equals_text = "a b";
  ClaimCheck small = check_of(CheckSubject::value, {{"error"}});
  small.high = 1e-12;
  ClaimCheck exponent =
      check_of(CheckSubject::exponent, {{"y1", "x1", "y2", "x2", "y3", "x3", "y4", "x4"}});
  exponent.low = 0.8;
  exponent.high = 1.6;
  const std::vector<ClaimCheck> checks = {
      text,
      matches,
      small,
      exponent,
      at_least(1.2, check_of(CheckSubject::ratio, {{"r", "s"}})),
      at_least(-3.0, check_of(CheckSubject::ratio_of_ratios, {{"a", "b", "c", "d"}})),
      at_least(1.0, check_of(CheckSubject::sum, {{"-e", "+f", "+g"}})),
      check_of(CheckSubject::same, {{"h", "i", "j"}}),
      check_of(CheckSubject::different, {{"k", "l"}})};
  for (const ClaimCheck& check : checks)
    EXPECT_TRUE(fulfilled(claim_of({check}), {})) << static_cast<int>(check.subject);
  EXPECT_TRUE(fulfilled(claim_of(checks), {}));
}

TEST(FulfilledClaim, SettlesOrdersThatShareTheirMembers) {
  const Claim order = claim_of({at_least(
      1.1, check_of(CheckSubject::ratio, {{"a", "b"}, {"b", "c"}, {"c", "d"}, {"d", "e"}}))});
  const Measurements wrong = {{"a", 1.0}, {"b", 2.0}, {"c", 3.0}, {"d", 4.0}, {"e", 5.0}};
  EXPECT_FALSE(holds(order, wrong));
  EXPECT_TRUE(fulfilled(order, wrong));
}

TEST(FulfilledClaim, IsAbsentWhereChecksContradictEachOther) {
  ClaimCheck other = check_of(CheckSubject::value, {{"m"}});
  other.high = 1.0;
  const Claim claim =
      claim_of({at_least(2.0, check_of(CheckSubject::value, {{"m"}})), std::move(other)});
  EXPECT_FALSE(fulfilled(claim, {{"m", 1.5}}));
}

TEST(FulfilledClaim, CountsOneThatHoldsByAnErratum) {
  Claim claim = claim_of({at_least(1.0, check_of(CheckSubject::value, {{"m"}}))});
  claim.erratum = "E1";
  EXPECT_TRUE(holds(claim, {{"m", 2.0}}));
  EXPECT_EQ(verdict_on(claim, {{"m", 2.0}}), Verdict::reproduced_with_erratum);
  EXPECT_EQ(verdict_on(claim, {}), Verdict::not_measured);
}

}  // namespace
}  // namespace phytobench
