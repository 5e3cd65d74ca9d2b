// SPDX-License-Identifier: MIT
#include "reports/judge/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

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

TEST(Evidence, HasMediansOfNumbersAndSaysOnHowManyRoundsTheyRest) {
  const Evidence evidence(mixed_run());
  EXPECT_EQ(evidence.median_of("p/e/count")->value, 7.0);
  EXPECT_EQ(evidence.median_of("p/e/count")->rounds, 0u) << "it is exact";
  EXPECT_EQ(evidence.median_of("p/e/seconds")->value, 0.5);
  EXPECT_EQ(evidence.median_of("p/e/seconds")->rounds, 3u);
  EXPECT_FALSE(evidence.median_of("p/e/text"));
  EXPECT_FALSE(evidence.median_of("p/e/unknown"));
}

TEST(Evidence, DividesTimesOfTheSameRoundOnly) {
  RunContents run = mixed_run();
  for (const std::int64_t round : {1, 2, 7})
    run.timings.push_back(sample_of("p/e/half", round, round == 1 ? 0.25 : 0.125));
  const Evidence evidence(run);
  const auto ratio = evidence.ratio_of("p/e/seconds", "p/e/half");
  EXPECT_EQ(ratio->rounds, 2u);
  EXPECT_EQ(ratio->low, 2.0);
  EXPECT_EQ(ratio->high, 2.0);
  run.timings = {sample_of("p/e/a", 0, 1.0), sample_of("p/e/b", 1, 1.0)};
  EXPECT_FALSE(Evidence(run).ratio_of("p/e/a", "p/e/b")) << "no round has both";
}

TEST(Evidence, DividesRecordedNumbersExactly) {
  const Evidence evidence(mixed_run());
  EXPECT_EQ(evidence.ratio_of("p/e/count", "p/e/real")->value, 14.0);
  EXPECT_EQ(evidence.ratio_of("p/e/count", "p/e/real")->rounds, 0u);
  EXPECT_FALSE(evidence.ratio_of("p/e/count", "p/e/text"));
  EXPECT_FALSE(evidence.ratio_of("p/e/count", "p/e/seconds"));
}

TEST(Evidence, KnowsHowManyRandomValuesAreSummedUp) {
  RunContents run = mixed_run();
  run.records[1].sample_size = 40;
  const Evidence evidence(run);
  EXPECT_EQ(evidence.sample_size("p/e/real"), 40);
  EXPECT_EQ(evidence.sample_size("p/e/count"), 1);
  EXPECT_EQ(evidence.sample_size("p/e/unknown"), 1);
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

TEST(ShownValue, HoldsAsManyDigitsAsAskedFor) {
  EXPECT_EQ(shown(1.0 / 3.0, 9), "0.333333333");
  EXPECT_EQ(shown(5200.0, 2), "5200") << "whole numbers are exact";
}

int digits_between(double number, double bound, int least = shown_digits) {
  return digits_to_tell_apart(std::vector{number}, std::vector{bound}, least);
}

TEST(DigitsToTellApart, AreAsFewAsWillDo) {
  EXPECT_EQ(digits_between(1.2, 1.3), 6);
  EXPECT_EQ(digits_between(1.2, 1.3, 4), 4);
  EXPECT_EQ(digits_between(1.2345678, 1.2345), 6);
  EXPECT_EQ(digits_between(1.23456, 1.23456), 6) << "equal numbers may look equal";
  EXPECT_EQ(digits_between(0.99999999, 1.0), 8);
  EXPECT_EQ(digits_between(1.0000004, 1.0), 8);
  EXPECT_EQ(digits_between(std::nextafter(1.0, 2.0), 1.0), 17);
  EXPECT_EQ(digits_between(std::nextafter(1.0, 0.0), 1.0), 16);
  EXPECT_EQ(digits_between(std::nextafter(0.1, 1.0), 0.1), 17);
}

// 1.2345649 is told from its bound by six digits, the other value only by seven - with which the
// first is no longer told from it.
TEST(DigitsToTellApart, DoNotForgetAPairThatMoreDigitsMakeEqual) {
  EXPECT_EQ(digits_between(1.2345649, 1.2345651), 6);
  EXPECT_EQ(digits_between(1.2345688, 1.2345651), 7);
  const std::vector numbers{1.2345649, 1.2345688}, backwards{1.2345688, 1.2345649};
  EXPECT_EQ(digits_to_tell_apart(numbers, std::vector{1.2345651}), 8);
  EXPECT_EQ(digits_to_tell_apart(backwards, std::vector{1.2345651}), 8);
}

// With four digits the bound would be 1234000 and the value above it, as it should be. But a bound
// is shown with six: 1.23447e+06 seems to be more than the whole number 1234467.
TEST(DigitsToTellApart, AreThoseWithWhichBoundsAreShown) {
  EXPECT_EQ(digits_between(1234467.0, 1234466.9, 4), 8);
}

TEST(DigitsToTellApart, BearNumbersThatAreNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(digits_between(infinity, 1.0), 6);
  EXPECT_EQ(digits_between(std::numeric_limits<double>::quiet_NaN(), 1.0), 6);
  EXPECT_EQ(digits_between(4.9e-324, 0.0), 6) << "beyond what std::stod reads";
}

// Whatever a number and its bound are, a reader sees on which side it lies.
TEST(DigitsToTellApartLaw, KeepOrderAndOneFewerDoesNot) {
  CounterStream stream(60, 0);
  for (int i = 0; i < 2000; ++i) {
    const double bound = 10.0 * stream.next_unit() - 5.0;
    const double number = bound + std::pow(10.0, -16.0 * stream.next_unit()) *
                                      (stream.next_unit() < 0.5 ? -1.0 : 1.0);
    if (number == bound) continue;
    const int digits = digits_between(number, bound);
    const auto order = [&](int d) {
      const double a = std::stod(shown(number, d)), b = std::stod(shown(bound, d));
      return (a > b) - (a < b);
    };
    EXPECT_EQ(order(digits), number > bound ? 1 : -1) << number << " " << bound;
    if (digits > shown_digits) {
      EXPECT_EQ(order(digits - 1), 0);
    }
  }
}

/// Whether a reader sees all numbers on their side of all bounds.
bool are_in_order(const std::vector<double>& numbers, const std::vector<double>& bounds,
                  int digits) {
  const auto side = [](double number, double bound) { return (number > bound) - (number < bound); };
  for (const double number : numbers)
    for (const double bound : bounds)
      if (side(number, bound) != side(std::stod(shown(number, digits)),
                                      std::stod(shown(bound, std::max(digits, shown_digits)))))
        return false;
  return true;
}

// What holds for one number must hold for several beside each other, and for whole ones, which are
// shown in full.
TEST(DigitsToTellApartLaw, KeepTheOrderOfAllNumbersAndOneFewerDoesNot) {
  CounterStream stream(61, 0);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10.0, 8.0 * stream.next_unit());
    const std::vector bounds{scale, scale * (1.0 + 1e-3 * stream.next_unit())};
    const int least = i % 2 == 0 ? shown_digits : 4;
    std::vector<double> numbers;
    for (int n = 0; n < 4; ++n) {
      const double off = std::pow(10.0, -9.0 * stream.next_unit());
      numbers.push_back(scale * (stream.next_unit() < 0.5 ? 1.0 - off : 1.0 + off));
      if (n == 3) numbers.back() = std::round(numbers.back());
    }
    const int digits = digits_to_tell_apart(numbers, bounds, least);
    EXPECT_TRUE(are_in_order(numbers, bounds, digits)) << "case " << i;
    if (digits > least) {
      EXPECT_FALSE(are_in_order(numbers, bounds, digits - 1)) << "case " << i;
    }
  }
}

TEST(ShownRange, HoldsAsManyDigitsAsAskedFor) {
  EXPECT_EQ(shown_range(1.0 / 3.0, 2.0 / 3.0, 8), "0.33333333 to 0.66666667");
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
