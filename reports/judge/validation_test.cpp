// SPDX-License-Identifier: MIT
#include "reports/judge/validation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

void put(RunContents& run, const std::string& measurement, RecordValue value,
         std::int64_t sample_size = 1) {
  run.records.push_back({.experiment = measurement.substr(0, measurement.find('/', 6)),
                         .measurement = measurement,
                         .value = std::move(value),
                         .sample_size = sample_size});
}

void put_answer(RunContents& run, const std::string& name, double certified, double computed,
                double digits) {
  const std::string path = "suite/certified-statistics/nist/" + name;
  put(run, path + "/certified", certified);
  put(run, path + "/computed", computed);
  put(run, path + "/digits", digits);
}

TEST(Validation, OfNothingIsEmpty) {
  EXPECT_FALSE(validation_of({}).any());
  RunContents run;
  put(run, "brzoska2019/table-1/points", std::int64_t{3});
  EXPECT_FALSE(validation_of(run).any());
}

TEST(CertifiedAnswers, KeepTheWorstOfSeveral) {
  RunContents run;
  put_answer(run, "wampler_1/coefficient_0/polynomial_regression", 1.0, 1.1, 1.0);
  put_answer(run, "wampler_1/coefficient_1/polynomial_regression", 1.0, 1.5, 0.3);
  put_answer(run, "wampler_1/coefficient_2/polynomial_regression", 1.0, 1.01, 2.0);
  put_answer(run, "wampler_1/r_squared/polynomial_regression", 1.0, 1.0, 15.0);
  put_answer(run, "num_acc_1/mean/sums_of_squares", 3.0, 3.0, 15.0);
  const auto answers = certified_answers(run);
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].statistic, "coefficient");
  EXPECT_EQ(answers[0].answers, 3);
  EXPECT_EQ(answers[0].computed, 1.5);
  EXPECT_EQ(answers[0].digits, 0.3);
  EXPECT_EQ(answers[1].statistic, "r_squared");
  EXPECT_FALSE(answers[1].is_counter_example);
  EXPECT_TRUE(answers[2].is_counter_example);
}

TEST(CertifiedAnswers, NameStatisticsThatEndInANumberInTheMiddle) {
  RunContents run;
  put_answer(run, "num_acc_1/lag_1_autocorrelation/moments", -0.5, -0.5, 15.0);
  put(run,
      "suite/certified-statistics/nist/num_acc_1/lag_1_autocorrelation/moments/"
      "reachable_digits",
      12.0);
  put_answer(run, "num_acc_1/lag_1_autocorrelation/another", -0.5, -0.5, 15.0);
  put_answer(run, "num_acc_2/lag_1_autocorrelation/another", -0.5, -0.5, 15.0);
  const auto answers = certified_answers(run);
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].statistic, "lag_1_autocorrelation");
  EXPECT_EQ(answers[0].reachable, 12.0);
  EXPECT_EQ(answers[1].reachable, 12.0) << "the data are the same";
  EXPECT_FALSE(answers[2].reachable);
}

TEST(CertifiedAnswers, TellWhatNothingElseUses) {
  RunContents run;
  put_answer(run, "num_acc_1/standard_deviation/moments", 1.0, 1.0, 15.0);
  put_answer(run, "num_acc_1/standard_deviation/running_moments", 1.0, 1.0, 15.0);
  put_answer(run, "num_acc_1/mean/moments", 1.0, 1.0, 15.0);
  put_answer(run, "longley/coefficient_1/polynomial_regression", 1.0, 1.0, 15.0);
  const auto answers = certified_answers(run);
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_TRUE(answers[0].is_unused);
  EXPECT_FALSE(answers[1].is_unused);
  EXPECT_FALSE(answers[2].is_unused);
  EXPECT_TRUE(answers[3].is_unused);
}

TEST(CertifiedAnswers, LeaveOutWhatIsHalfWritten) {
  RunContents run;
  put(run, "suite/certified-statistics/nist/num_acc_1/mean/moments/digits", 15.0);
  EXPECT_TRUE(certified_answers(run).empty());
}

TEST(IntervalRanks, KnowWhereNoneExists) {
  RunContents run;
  for (const std::string count : {"05", "09"}) {
    const std::string path = "suite/interval-coverage/ranks/" + count;
    put(run, path + "/bootstrap/low", std::int64_t{1});
    put(run, path + "/bootstrap/high", std::int64_t{5});
    put(run, path + "/bootstrap/coverage", 0.9375);
    put(run, path + "/bootstrap/other_ends", std::int64_t{1}, 20);
  }
  put(run, "suite/interval-coverage/ranks/09/order_statistics/low", std::int64_t{2});
  put(run, "suite/interval-coverage/ranks/09/order_statistics/high", std::int64_t{8});
  put(run, "suite/interval-coverage/ranks/09/order_statistics/coverage", 0.961);
  const auto rows = interval_ranks(run);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].values, 5);
  EXPECT_EQ(rows[0].tried, 20);
  EXPECT_FALSE(rows[0].order_statistics);
  ASSERT_TRUE(rows[1].order_statistics);
  EXPECT_EQ(rows[1].order_statistics->ranks.high, 8u);
}

TEST(SimulatedCoverage, HasABinomialInterval) {
  RunContents run;
  put(run, "suite/interval-coverage/median/09/skewed/bootstrap/covered", std::int64_t{950}, 1000);
  const auto rows = simulated_coverage(run);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].values, 9);
  EXPECT_EQ(rows[0].law, "skewed");
  EXPECT_EQ(rows[0].share.value, 0.95);
  EXPECT_LT(rows[0].share.low, 0.94);
  EXPECT_GT(rows[0].share.high, 0.96);
}

TEST(Transcriptions, AreFoundByName) {
  RunContents run;
  put(run, "alsweis/x/agreement/size_difference", -1e-15);
  put(run, "alsweis/x/pairs/largest_difference_from_print", 0.0);
  put(run, "alsweis/x/agreement/points", std::int64_t{7});
  put(run, "alsweis/x/mean_difference", 3.0);
  const auto rows = transcriptions(run);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].difference, 1e-15);
}

TEST(ObservedOrders, AreFittedOverAllSteps) {
  RunContents run;
  for (const int n : {100, 200, 400, 800}) {
    const std::string path = "alsweis/growth-steps/step-" + std::to_string(n);
    put(run, path + "/length", 1.0 / n);
    put(run, path + "/explicit_error", 3.0 / n / n);
  }
  const auto orders = observed_orders(run);
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_NEAR(orders[0].order.value, 2.0, 1e-12);
  EXPECT_EQ(orders[0].expected, 1.0);
}

void put_rounds(RunContents& run, const std::string& name, int count, double flip) {
  for (int round = count; round-- > 0;)  // not in order
    run.timings.push_back({.experiment = "a/b",
                           .measurement = "a/b/" + name,
                           .round = round,
                           .value = std::exp(round % 2 == 0 ? flip : -flip)});
}

TEST(RoundMemories, SeeThatRoundsTakeTurns) {
  RunContents run;
  put_rounds(run, "turns", 20, 0.1);
  put_rounds(run, "few", 8, 0.1);
  put_rounds(run, "constant", 20, 0.0);
  const auto rows = round_memories(run);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].series, 1);
  EXPECT_NEAR(rows[0].median_correlation, -0.95, 1e-12);
  EXPECT_EQ(rows[0].beyond, 1);
}

TEST(Validation, CountsSamples) {
  RunContents run;
  put(run, "alsweis/x/a", 1.0, 30);
  put(run, "alsweis/x/b", 1.0, 30);
  run.records.back().spread = 0.5;
  put(run, "alsweis/x/c", 1.0);
  EXPECT_EQ(validation_of(run).sampled_records, 2);
  EXPECT_EQ(validation_of(run).spread_records, 1);
}

}  // namespace
}  // namespace phytobench
