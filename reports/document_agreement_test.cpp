// SPDX-License-Identifier: MIT
#include "reports/document_agreement.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

Record record_of(const std::string& measurement, RecordValue value) {
  return {.experiment = "b/x", .measurement = measurement, .value = std::move(value)};
}

/// A claim that says "200", judged between 150 and 250 on one measurement.
struct TwoHundred {
  Claim claim;
  RunContents run;

  TwoHundred() {
    claim.published = "200";
    claim.checks = {{.terms = {{"b/x/n"}}, .low = 150.0, .high = 250.0, .required = 1}};
    run.records = {record_of("b/x/n", std::int64_t{202}), record_of("b/x/m", 2.0)};
  }
  std::string agreement() const { return shown_agreement(claim, Evidence(run)); }
};

TEST(NumberIn, ReadsWholeTextsOnly) {
  EXPECT_EQ(number_in("49.3"), 49.3);
  EXPECT_EQ(number_in("0,8"), 0.8);
  EXPECT_EQ(number_in("-1e-3"), -1e-3);
  for (const char* text : {"", "-", "more likely", "20 of 20", "1.2 to 1.4", "1,234.5", "1.2x"})
    EXPECT_FALSE(number_in(text)) << text;
}

TEST(Agreement, IsShownForOneNumberOfEach) {
  TwoHundred of;
  EXPECT_EQ(of.agreement(), "2 of 3 digits");
  of.claim.checks[0].terms = {{"b/x/n", "b/x/m"}};
  of.claim.checks[0].subject = CheckSubject::ratio;
  of.claim.published = "101";
  of.claim.checks[0].low = 100.0;
  EXPECT_EQ(of.agreement(), "all digits");
}

std::string agreement_of(const std::string& published, double computed) {
  TwoHundred of;
  of.claim.published = published;
  of.claim.checks[0].low = -1e9;
  of.claim.checks[0].high = 1e9;
  of.run.records = {record_of("b/x/n", computed)};
  return of.agreement();
}

TEST(Agreement, CountsWholeDigitsAndNoMoreThanArePrinted) {
  EXPECT_EQ(agreement_of("49.3", 49.34), "all digits");
  EXPECT_EQ(agreement_of("49.3", 49.36), "2 of 3 digits") << "it would print as 49.4";
  EXPECT_EQ(agreement_of("1.02", 1.0249), "all digits");
  EXPECT_EQ(agreement_of("1.02", 1.03), "2 of 3 digits");
  EXPECT_EQ(agreement_of("0.050", 0.051), "1 of 2 digits");
  EXPECT_EQ(agreement_of("-200", -202.0), "2 of 3 digits");
  EXPECT_EQ(agreement_of("-1e-3", -1.4e-3), "all digits");
  EXPECT_EQ(agreement_of("0,8", 0.9), "0 of 1 digit");
  EXPECT_EQ(agreement_of("5200", -1e8), "0 of 4 digits");
}

TEST(Agreement, IsNotShownForSampledValues) {
  TwoHundred by_reason, by_size;
  by_reason.claim.checks[0].why = "sampling error";
  by_size.run.records[0].sample_size = 30;
  EXPECT_EQ(by_reason.agreement(), "");
  EXPECT_EQ(by_size.agreement(), "");
}

TEST(Agreement, IsNotInventedForOtherChecks) {
  TwoHundred two_checks, one_bound, elsewhere, two_terms, unmeasured, zero;
  two_checks.claim.checks.push_back(two_checks.claim.checks.front());
  one_bound.claim.checks[0].high.reset();
  elsewhere.claim.checks[0].high = 199.0;  // a bound on something else
  two_terms.claim.checks[0].terms.push_back({"b/x/m"});
  unmeasured.claim.checks[0].terms = {{"b/x/absent"}};
  zero.claim.published = "0";
  zero.claim.checks[0].low = -1.0;
  for (const TwoHundred* of : {&two_checks, &one_bound, &elsewhere, &two_terms, &unmeasured, &zero})
    EXPECT_EQ(of->agreement(), "");
}

TEST(Agreement, IsNotShownForTimes) {
  TwoHundred of;
  of.run.timings = {{.experiment = "b/x", .measurement = "b/x/n", .value = 202.0}};
  EXPECT_EQ(of.agreement(), "");
}

}  // namespace
}  // namespace phytobench
