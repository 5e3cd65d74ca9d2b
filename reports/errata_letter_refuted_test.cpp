// SPDX-License-Identifier: MIT
#include "reports/errata_letter_refuted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;

/// The line of a claim that is judged on one recorded value.
std::string entry_of(const ClaimCheck& bounds, const RecordValue& value) {
  Claim claim;
  claim.id = "w/a";
  claim.locator = "eq. 1";
  claim.text = "It is small";
  claim.reason = "Because.";
  claim.checks = {bounds};
  claim.checks[0].terms = {{"w/e/value"}};
  claim.checks[0].required = 1;
  RunContents run;
  run.records.push_back({.experiment = "w/e", .measurement = "w/e/value", .value = value});
  return refuted_entry(judge(claim, Evidence(run), Tier::full), {});
}

TEST(RefutedEntry, SaysWhereTheMachineDecides) {
  Claim claim;
  claim.reason = "Because.";
  Judgement judgement;
  judgement.claim = &claim;
  EXPECT_THAT(refuted_entry(judgement, {}), testing::Not(HasSubstr("depends on the machine")));
  claim.machine_dependence = "it holds on others";
  EXPECT_THAT(refuted_entry(judgement, {}),
              HasSubstr("It depends on the machine: it holds on others."));
}

TEST(RefutedEntry, DoesNotRoundAValueToTheBoundThatItMisses) {
  EXPECT_THAT(entry_of({.high = 0.9}, 0.9 + 1e-9),
              HasSubstr("Measured in this way: 0.900000001; needed: at most 0.9."));
  EXPECT_THAT(entry_of({.equals = 1.0}, 0.99999),
              HasSubstr("Measured in this way: 0.99999; needed: exactly 1."));
}

TEST(RefutedEntry, ShowsWholeNumbersInFull) {
  EXPECT_THAT(entry_of({.high = 20000.0}, std::int64_t{20046}),
              HasSubstr("Measured in this way: 20046; needed: at most 20000."));
}

TEST(RefutedEntry, TellsWhatIsPracticallyZeroFromATinyBound) {
  EXPECT_THAT(entry_of({.high = 1e-12}, 1e-10),
              HasSubstr("Measured in this way: practically 0 (1e-10); needed: at most 1e-12"));
}

}  // namespace
}  // namespace phytobench
