// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/timings_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/record/run_folder_fixture.hpp"
#include "core/record/timings_file.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;

class RunAsResult : public RunFolder {};

TEST_F(RunAsResult, HoldsItsTimes) {
  write_run({"p/one", "p/two"});
  const StoredResult result = read_stored_result(folder_);
  ASSERT_EQ(result.benchmarks.size(), 2u);
  EXPECT_EQ(result.benchmarks[0].name, "p/one/time");
  EXPECT_THAT(result.benchmarks[0].repetitions(), ElementsAre(0.5, 0.25));
  EXPECT_FALSE(result.benchmarks[0].is_by_process);
  EXPECT_EQ(result.origin.kind, "result");
}

TEST_F(RunAsResult, WhatIsNoRunIsRefused) {
  std::filesystem::create_directories(folder_);
  EXPECT_NE(input_error([&] { read_stored_result(folder_); }), "no error");
}

TEST(TimingsResult, TakesSecondsOnlyAndKeepsThreadsApart) {
  TimingSample memory = timing_of("p/one", 3.0);
  memory.measurement = "p/one/memory";
  memory.unit = "MiB";
  TimingSample parallel = timing_of("p/one", 0.125);
  parallel.threads = 2;
  SealedText file(timings_header());
  file.add("", timings_session("e"));
  file.add(timing_line("p/one", 0.5) + to_json_line(memory) + "\n" + to_json_line(parallel) + "\n",
           timings_completion("p/one", 3, "r", {}));
  ASSERT_TRUE(is_timings_text(file.text()));
  const StoredResult result = timings_result_from("nowhere/timings.jsonl", file.text());
  ASSERT_EQ(result.benchmarks.size(), 2u);
  EXPECT_EQ(result.benchmarks[0].name, "p/one/time");
  EXPECT_EQ(result.benchmarks[1].name, "p/one/time/threads:2");
  EXPECT_THAT(result.benchmarks[1].repetitions(), ElementsAre(0.125));
  EXPECT_EQ(result.machine.logical_processors, 0);  // unknown, so that nothing is concluded
}

TEST(TimingsResult, OtherTextIsNone) {
  EXPECT_FALSE(is_timings_text("{\"schema\": \"phytobench/result-1\"}"));
  EXPECT_FALSE(is_timings_text("{\n\"x\": \"phytobench/timings-2\"}"));
  EXPECT_FALSE(is_timings_text(""));
}

}  // namespace
}  // namespace phytobench
