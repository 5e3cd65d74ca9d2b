// SPDX-License-Identifier: MIT
#include "benchmarks/regression/sampling.hpp"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// Counts its runs; the answer changes at the run of that number.
class CountingKernel final : public WatchedKernel {
 public:
  CountingKernel(std::uint64_t& runs, std::uint64_t turns_wrong)
      : runs_(runs), turns_wrong_(turns_wrong) {}

  std::string inputs() const override { return "inputs"; }
  void run() override {
    ++runs_;
    for (int i = 0; i < 1000; ++i) sum_ = sum_ + 1.0 / (1.0 + i);
  }
  std::string answer() const override { return runs_ >= turns_wrong_ ? "wrong" : "right"; }
  WorkCounts work() const override { return {{"terms", 1000}}; }
  std::string objection() override { return answer() == "right" ? "" : "wrong"; }

 private:
  std::uint64_t& runs_;
  std::uint64_t turns_wrong_;
  volatile double sum_ = 0.0;
};

WatchedBenchmark counting(std::uint64_t& runs, std::uint64_t turns_wrong = ~std::uint64_t{0}) {
  return {.name = "counting", .summary = "", .is_own = true, .prepare = [&runs, turns_wrong] {
            return std::make_unique<CountingKernel>(runs, turns_wrong);
          }};
}

SamplePlan plan_of(std::uint64_t iterations, int samples, const std::string& answer = "right") {
  return {.seed = 7, .samples = samples, .benchmarks = {{"counting", iterations, answer}}};
}

std::uint64_t counted_iterations(const SampledBenchmark& sampled) {
  std::uint64_t sum = 0;
  for (const TimedSample& sample : sampled.samples) sum += sample.iterations;
  return sum;
}

TEST(Sampling, TakesAsManySamplesAsPlannedOfAboutThatLength) {
  std::uint64_t runs = 0;
  const auto sampled = sample_benchmarks({counting(runs)}, plan_of(100, 8));
  ASSERT_EQ(sampled.size(), 1u);
  ASSERT_EQ(sampled[0].samples.size(), 8u);
  for (const TimedSample& sample : sampled[0].samples) {
    EXPECT_GE(sample.iterations, 80u);
    EXPECT_LE(sample.iterations, 120u);
    EXPECT_GT(sample.cpu_s, 0.0);
    EXPECT_GT(sample.wall_s, 0.0);
  }
  EXPECT_EQ(runs, 51 + counted_iterations(sampled[0])) << "51 to warm up, all others counted";
}

TEST(Sampling, AHandicapRunsSoManyMoreThanItSays) {
  std::uint64_t runs = 0;
  const auto sampled = sample_benchmarks({counting(runs)}, plan_of(100, 8), {.handicap = 0.1});
  const std::uint64_t counted = counted_iterations(sampled[0]);
  EXPECT_NEAR(static_cast<double>(runs - 51 - counted), 0.1 * static_cast<double>(counted), 1.0);
}

TEST(Sampling, AHandicapHoldsForSingleIterationsToo) {
  std::uint64_t runs = 0;
  sample_benchmarks({counting(runs)}, plan_of(1, 20), {.handicap = 0.1});
  EXPECT_EQ(runs, 1u + 20u + 2u);
}

TEST(Sampling, AWrongAnswerGetsNoTime) {
  std::uint64_t runs = 0;
  const auto never = sample_benchmarks({counting(runs)}, plan_of(10, 3, "other"));
  EXPECT_THAT(never[0].objection, testing::HasSubstr("not the one that was verified"));
  EXPECT_TRUE(never[0].samples.empty());
  runs = 0;
  const auto later = sample_benchmarks({counting(runs, 20)}, plan_of(10, 3));
  EXPECT_NE(later[0].objection, "");
  EXPECT_TRUE(later[0].samples.empty()) << "not even those before it went wrong";
}

TEST(Sampling, WorkInOtherThreadsIsNotHidden) {
  class Helped final : public WatchedKernel {
    std::string inputs() const override { return ""; }
    void run() override {
      std::thread helper([this] {
        for (int i = 0; i < 2'000'000; ++i) sum_ = sum_ + 1.0 / (1.0 + i);
      });
      helper.join();
    }
    std::string answer() const override { return "right"; }
    WorkCounts work() const override { return {}; }
    std::string objection() override { return ""; }
    volatile double sum_ = 0.0;
  };
  const WatchedBenchmark helped{.name = "counting", .summary = "", .is_own = true, .prepare = [] {
                                  return std::make_unique<Helped>();
                                }};
  const auto sampled = sample_benchmarks({helped}, plan_of(2, 2));
  EXPECT_THAT(sampled[0].objection, testing::HasSubstr("other threads"));
  EXPECT_TRUE(sampled[0].samples.empty());
}

TEST(Sampling, WhatStopsWorkingGetsNoTime) {
  class Idle final : public WatchedKernel {
    std::string inputs() const override { return ""; }
    void run() override {}
    std::string answer() const override { return "right"; }
    WorkCounts work() const override { return {}; }
    std::string objection() override { return ""; }
  };
  const WatchedBenchmark idle{.name = "counting", .summary = "", .is_own = true, .prepare = [] {
                                return std::make_unique<Idle>();
                              }};
  // Of a single run the clocks take more than of a hundred thousand that do nothing.
  for (const std::uint64_t iterations :
       {std::uint64_t{1}, std::uint64_t{25}, std::uint64_t{100'000}}) {
    const auto sampled = sample_benchmarks({idle}, plan_of(iterations, 5));
    EXPECT_THAT(sampled[0].objection, testing::HasSubstr("takes no time")) << iterations;
    EXPECT_TRUE(sampled[0].samples.empty());
  }
}

TEST(Sampling, PlansThatAskForNothingOrTheUnknownAreRefused) {
  std::uint64_t runs = 0;
  EXPECT_THROW(sample_benchmarks({counting(runs)}, plan_of(0, 3)), InputError);
  EXPECT_THROW(sample_benchmarks({counting(runs)}, plan_of(10, 0)), InputError);
  EXPECT_THROW(sample_benchmarks({}, plan_of(10, 3)), InputError);
}

TEST(Calibration, WhatTakesNoTimeHasNoIterations) {
  class Nothing final : public WatchedKernel {
    std::string inputs() const override { return ""; }
    void run() override {}
    std::string answer() const override { return ""; }
    WorkCounts work() const override { return {}; }
    std::string objection() override { return ""; }
  };
  const WatchedBenchmark nothing{.name = "nothing", .summary = "", .is_own = true, .prepare = [] {
                                   return std::make_unique<Nothing>();
                                 }};
  EXPECT_EQ(calibrate_benchmark(nothing, 10.0).iterations, 0u);
  std::uint64_t runs = 0;
  EXPECT_GT(calibrate_benchmark(counting(runs), 0.001).iterations, 0u);
}

TEST(Verification, AnObjectionAndTheWorkAreTold) {
  std::uint64_t runs = 0;
  const VerifiedBenchmark right = verify_benchmark(counting(runs));
  EXPECT_EQ(right.objection, "");
  EXPECT_EQ(right.work.at("terms"), 1000u);
  runs = 0;
  EXPECT_EQ(verify_benchmark(counting(runs, 1)).objection, "wrong");
}

}  // namespace
}  // namespace phytobench
