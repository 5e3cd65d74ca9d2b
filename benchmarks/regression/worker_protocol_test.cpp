// SPDX-License-Identifier: MIT
#include "benchmarks/regression/worker_protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

SamplePlan some_plan() {
  return {.seed = 18446744073709551615u,
          .samples = 3,
          .benchmarks = {{.name = "a/b", .iterations = 12, .answer = "0f"}}};
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WorkerProtocol, EveryMessageComesBackAsItWas) {
  const WorkerDescription described =
      worker_description_from(to_json(WorkerDescription{.compiler = "GNU 12",
                                                        .flags = "-O3",
                                                        .counts_work = true,
                                                        .benchmarks = {{"a", "b", false}}}),
                              "w");
  EXPECT_EQ(described.compiler + described.flags, "GNU 12-O3");
  EXPECT_TRUE(described.counts_work);
  ASSERT_EQ(described.benchmarks.size(), 1u);
  EXPECT_FALSE(described.benchmarks[0].is_own);

  const SamplePlan plan = sample_plan_from(to_json(some_plan()), "w");
  EXPECT_EQ(plan.seed, 18446744073709551615u);
  EXPECT_EQ(plan.samples, 3);
  ASSERT_EQ(plan.benchmarks.size(), 1u);
  EXPECT_EQ(plan.benchmarks[0].answer, "0f");

  const auto verified = verified_from(
      to_json(std::vector<VerifiedBenchmark>{{"n", "i", "a", "o", {{"pairs", 1u << 31}}}}), "w");
  ASSERT_EQ(verified.size(), 1u);
  EXPECT_EQ(verified[0].work.at("pairs"), 1u << 31);

  const auto calibrated =
      calibrated_from(to_json(std::vector<CalibratedBenchmark>{{"n", 7, 0.1}}), "w");
  ASSERT_EQ(calibrated.size(), 1u);
  EXPECT_EQ(calibrated[0].seconds, 0.1);

  const auto sampled =
      sampled_from(to_json(std::vector<SampledBenchmark>{{"n", "", {{3, 0.25, 0.1}}, 9}}), "w");
  ASSERT_EQ(sampled.size(), 1u);
  ASSERT_EQ(sampled[0].samples.size(), 1u);
  EXPECT_EQ(sampled[0].samples[0].wall_s, 0.1);
  EXPECT_EQ(sampled[0].involuntary_switches, 9);
}

TEST(WorkerProtocol, WhatIsNoAnswerIsRefusedByName) {
  EXPECT_THAT(message_of([] { sampled_from("Segmentation fault", "HEAD~1"); }),
              HasSubstr("HEAD~1: no answer to 'sample'"));
  EXPECT_THAT(message_of([] { sampled_from(to_json(some_plan()), "x"); }),
              HasSubstr("answered 'plan'"));
  std::string newer = to_json(some_plan());
  newer.replace(newer.find("worker-1"), 8, "worker-9");
  EXPECT_THAT(message_of([&] { sample_plan_from(newer, "x"); }), HasSubstr("worker-9"));
  std::string lacking = to_json(some_plan());
  lacking.replace(lacking.find("\"iterations\""), 12, "\"iteration_\"");
  EXPECT_THAT(message_of([&] { sample_plan_from(lacking, "x"); }), HasSubstr("iterations"));
}

}  // namespace
}  // namespace phytobench
