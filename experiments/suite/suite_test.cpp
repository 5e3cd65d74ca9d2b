// SPDX-License-Identifier: MIT
// What the suite's experiments on itself must find, whatever else changes.
#include <cmath>

#include <gtest/gtest.h>

#include "experiments/experiment_registry.hpp"

namespace phytobench {
namespace {

std::vector<Record> smoke_records(const std::string& id) {
  ExperimentContext context(id, Tier::smoke, 0, 1);
  selected_experiments({id})[0]->run(context);
  return context.records();
}

double number(const Record& record) {
  const auto* const whole = std::get_if<std::int64_t>(&record.value);
  return whole ? static_cast<double>(*whole) : std::get<double>(record.value);
}

// NumAcc3 and NumAcc4 are no doubles: their standard deviations have lost digits before any sum.
TEST(CertifiedStatistics, AgreeAsFarAsTheDataAllow) {
  std::size_t checked = 0;
  for (const Record& record : smoke_records("suite/certified-statistics")) {
    const std::string& name = record.measurement;
    if (!name.ends_with("/digits") || name.find("sums_of_squares") != std::string::npos) continue;
    const bool lost = name.find("num_acc_3/standard_deviation") != std::string::npos ||
                      name.find("num_acc_4/standard_deviation") != std::string::npos;
    const bool is_difference = name.find("/intercept/") != std::string::npos;
    EXPECT_GE(number(record), lost ? 8.2 : is_difference ? 12.0 : 13.0) << name;
    ++checked;
  }
  EXPECT_GT(checked, 90u);
}

TEST(CertifiedStatistics, ShowThatTheTextbooksFormulaFails) {
  double fewest = 15.0;
  for (const Record& record : smoke_records("suite/certified-statistics"))
    if (record.measurement.ends_with("/standard_deviation/sums_of_squares/digits"))
      fewest = std::min(fewest, number(record));
  EXPECT_LT(fewest, 1.0);
}

TEST(ExactDistributions, AgreeInThirteenDigits) {
  std::size_t checked = 0;
  for (const Record& record : smoke_records("suite/exact-distributions")) {
    const std::string& name = record.measurement;
    if (name.find("kolmogorov") != std::string::npos) {
      // What kolmogorov_smirnov.hpp promises of its approximation.
      if (name.ends_with("_values/largest_difference")) {
        EXPECT_LT(number(record), 0.023) << name;
      }
      if (name.ends_with("0.1/digits")) {
        EXPECT_GE(number(record), 1.3) << name << ": 4 % and rounded down";
      }
      continue;
    }
    if (!name.ends_with("/digits")) continue;
    EXPECT_GE(number(record), 13.0) << name;
    ++checked;
  }
  EXPECT_GE(checked, 11u);
}

/// Of simulated data sets, four binomial standard deviations off at most.
void expect_coverage(const Record& record, double expected) {
  const auto sets = static_cast<double>(record.sample_size);
  EXPECT_NEAR(number(record) / sets, expected, 4.0 * std::sqrt(expected * (1.0 - expected) / sets))
      << record.measurement;
}

TEST(IntervalCoverage, IsTheExactOneForIndependentTimes) {
  std::size_t checked = 0;
  for (const Record& record : smoke_records("suite/interval-coverage")) {
    const std::string& name = record.measurement;
    const bool independent = name.find("autocorrelated") == std::string::npos;
    if (!name.ends_with("/covered") || !independent || name.find("/exponent/") != std::string::npos)
      continue;
    expect_coverage(record, name.find("/03/") != std::string::npos   ? 0.75
                            : name.find("/05/") != std::string::npos ? 0.9375
                            : name.find("/09/") != std::string::npos ? 1.0 - 20.0 / 512.0
                                                                     : 0.956714749336);
    ++checked;
  }
  EXPECT_EQ(checked, 48u);
}

TEST(IntervalCoverage, OfStudentsExponentsIsNominalForLognormalTimesAndShortForDependentOnes) {
  for (const Record& record : smoke_records("suite/interval-coverage")) {
    const std::string& name = record.measurement;
    if (name.find("/exponent/") == std::string::npos) continue;
    if (name.find("/lognormal/") != std::string::npos) expect_coverage(record, 0.95);
    if (name.find("/autocorrelated/") != std::string::npos) {
      EXPECT_LT(number(record) / static_cast<double>(record.sample_size), 0.9) << name;
    }
  }
}

}  // namespace
}  // namespace phytobench
