// SPDX-License-Identifier: MIT
#include "reports/judge/evidence.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TimingSample sample_of(const std::string& measurement, std::int64_t round, double seconds,
                       std::int64_t threads = 1) {
  return {.experiment = "p/e",
          .measurement = measurement,
          .round = round,
          .position = 0,
          .value = seconds,
          .threads = threads};
}

RunContents mixed_run() {
  RunContents run;
  run.records.push_back(
      {.experiment = "p/e", .measurement = "p/e/count", .value = RecordValue{std::int64_t{7}}});
  run.records.push_back(
      {.experiment = "p/e", .measurement = "p/e/real", .value = RecordValue{0.5}});
  run.records.push_back(
      {.experiment = "p/e", .measurement = "p/e/text", .value = RecordValue{std::string("left")}});
  run.timings = {sample_of("p/e/seconds", 2, 0.25), sample_of("p/e/seconds", 0, 1.0),
                 sample_of("p/e/seconds", 1, 0.5)};
  return run;
}

TEST(Evidence, KnowsWhatWasMeasuredAndNothingElse) {
  const Evidence evidence(mixed_run());
  for (const char* measurement : {"p/e/count", "p/e/real", "p/e/text", "p/e/seconds"})
    EXPECT_TRUE(evidence.has(measurement)) << measurement;
  for (const char* measurement : {"", "p/e", "p/e/coun", "p/e/count/", "count"})
    EXPECT_FALSE(evidence.has(measurement)) << measurement;
}

TEST(Evidence, GivesRecordedValuesAsTheyAre) {
  const Evidence evidence(mixed_run());
  EXPECT_EQ(evidence.recorded("p/e/count"), RecordValue{std::int64_t{7}});
  EXPECT_EQ(evidence.recorded("p/e/real"), RecordValue{0.5});
  EXPECT_EQ(evidence.recorded("p/e/text"), RecordValue{std::string("left")});
}

TEST(Evidence, RecordsNoValueForATimingOrAnUnknownMeasurement) {
  const Evidence evidence(mixed_run());
  EXPECT_FALSE(evidence.recorded("p/e/seconds").has_value());
  EXPECT_FALSE(evidence.recorded("p/e/unknown").has_value());
}

TEST(Evidence, TellsTimingsFromRecords) {
  const Evidence evidence(mixed_run());
  EXPECT_TRUE(evidence.is_timing("p/e/seconds"));
  EXPECT_FALSE(evidence.is_timing("p/e/real"));
  EXPECT_FALSE(evidence.is_timing("p/e/unknown"));
}

TEST(Evidence, GivesOneSampleForANumberAndNoneForAText) {
  const Evidence evidence(mixed_run());
  EXPECT_EQ(evidence.samples("p/e/count"), std::vector<double>{7.0});
  EXPECT_EQ(evidence.samples("p/e/real"), std::vector<double>{0.5});
  EXPECT_TRUE(evidence.samples("p/e/text").empty());
  EXPECT_TRUE(evidence.samples("p/e/unknown").empty());
}

TEST(Evidence, GivesTimingsInTheOrderOfRounds) {
  const Evidence evidence(mixed_run());
  EXPECT_EQ(evidence.samples("p/e/seconds"), (std::vector<double>{1.0, 0.5, 0.25}));
}

TEST(Evidence, NamesTheLargestNumberOfThreads) {
  RunContents run = mixed_run();
  run.timings = {sample_of("p/e/seconds", 0, 1.0, 1), sample_of("p/e/seconds", 1, 1.0, 3),
                 sample_of("p/e/seconds", 2, 1.0, 2)};
  const Evidence evidence(run);
  EXPECT_EQ(evidence.threads("p/e/seconds"), 3);
  EXPECT_EQ(evidence.threads("p/e/count"), 1);
  EXPECT_EQ(evidence.threads("p/e/unknown"), 1);
}

TEST(ShownValue, HoldsWholeNumbersAsSuch) {
  EXPECT_EQ(shown(RecordValue{std::int64_t{9007199254740993}}), "9007199254740993");
  EXPECT_EQ(shown(RecordValue{std::int64_t{-5}}), "-5");
  EXPECT_EQ(shown(5200.0), "5200");
  EXPECT_EQ(shown(-3.0), "-3");
  EXPECT_EQ(shown(RecordValue{25298.0}), "25298");
}

TEST(ShownValue, HoldsRealsWithSixSignificantDigits) {
  EXPECT_EQ(shown(0.25), "0.25");
  EXPECT_EQ(shown(1.0 / 3.0), "0.333333");
  EXPECT_EQ(shown(1234567.5), "1.23457e+06");
  EXPECT_EQ(shown(RecordValue{1e-9}), "1e-09");
}

TEST(ShownValue, HoldsTextsUntouched) {
  EXPECT_EQ(shown(RecordValue{std::string("500fa216eb9f6dc4")}), "500fa216eb9f6dc4");
}

TEST(ShownRange, ShowsBoundsThatRoundingLeavesInPlace) {
  EXPECT_EQ(shown_range(1.0, 2.5), "1 to 2.5");
  EXPECT_EQ(shown_range(-1e-6, 1e-6), "-1e-06 to 1e-06");
  EXPECT_EQ(shown_range(1.0 / 3.0, 2.0 / 3.0), "0.333333 to 0.666667");
  EXPECT_EQ(shown_range(1234566.0, 1234568.0), "1234566 to 1234568");
}

TEST(ShownRange, ShowsCentreAndHalfWidthOfBoundsThatRoundingWouldMove) {
  EXPECT_EQ(shown_range(0.5 - 1e-9, 0.5 + 1e-9), "0.5 ± 1e-09");
  EXPECT_EQ(shown_range(-1.0 - 1e-9, -1.0 + 1e-9), "-1 ± 1e-09");
  EXPECT_EQ(shown_range(1.22837 - 1e-6, 1.22837 + 1e-6), "1.22837 ± 1e-06");
  EXPECT_EQ(shown_range(1.2283742 - 1e-6, 1.2283742 + 1e-6), "1.2283742 ± 1e-06");
}

TEST(ShownRange, ShowsOneNumberAsEqual) {
  EXPECT_EQ(shown_range(1.0, 1.0), "= 1");
}

}  // namespace
}  // namespace phytobench
