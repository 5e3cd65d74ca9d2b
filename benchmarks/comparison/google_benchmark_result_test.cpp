// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/google_benchmark_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// As version 1.7.1 writes it, of these entries.
std::string written(const std::string& entries) {
  return R"({
  "context": {
    "date": "2026-11-27T22:16:00+00:00",
    "host_name": "secret-host",
    "executable": "/some/where/fill_benchmark",
    "num_cpus": 2,
    "mhz_per_cpu": 2450,
    "cpu_scaling_enabled": false,
    "caches": [
      { "type": "Data", "level": 1, "size": 32768, "num_sharing": 2 },
      { "type": "Unified", "level": 2, "size": 524288, "num_sharing": 2 }
    ],
    "load_avg": [0.12,0.34,0.56],
    "library_build_type": "debug"
  },
  "benchmarks": [)" +
         entries + "]\n}\n";
}

std::string iteration(const std::string& name, const std::string& real, const std::string& cpu,
                      const std::string& unit = "ns", int repetition = 0) {
  return R"({"name": ")" + name + R"(", "family_index": 0, "per_family_instance_index": 0,
    "run_name": ")" +
         name + R"(", "run_type": "iteration", "repetitions": 2, "repetition_index": )" +
         std::to_string(repetition) + R"(, "threads": 1, "iterations": 1000, "real_time": )" +
         real + R"(, "cpu_time": )" + cpu + R"(, "time_unit": ")" + unit + "\"}";
}

std::string aggregate(const std::string& run, const std::string& kind, const std::string& cpu) {
  return R"({"name": ")" + run + "_" + kind + R"(", "run_name": ")" + run +
         R"(", "run_type": "aggregate", "aggregate_name": ")" + kind +
         R"(", "aggregate_unit": "time", "iterations": 2, "real_time": 5, "cpu_time": )" + cpu +
         R"(, "time_unit": "ns"})";
}

StoredResult read(const std::string& entries) {
  return google_benchmark_result_from(written(entries), "g.json");
}

std::string google_complaint(const std::string& json) {
  return input_error([&] { google_benchmark_result_from(json, "g.json"); });
}

TEST(GoogleBenchmarkResult, RepetitionsAreSamplesAndAggregatesAreNot) {
  const StoredResult result =
      read(iteration("fill/8", "12", "1.0000000000000000e+01") + "," +
           iteration("fill/8", "22", "2.0e+01", "ns", 1) + "," + aggregate("fill/8", "mean", "15") +
           "," + aggregate("fill/8", "cv", "NaN") + "," + aggregate("fill", "BigO", "-Infinity"));
  ASSERT_EQ(result.benchmarks.size(), 1u);
  EXPECT_EQ(result.benchmarks[0].name, "fill/8");
  EXPECT_FALSE(result.benchmarks[0].is_aggregate_only);
  EXPECT_FALSE(result.benchmarks[0].is_by_process);
  EXPECT_THAT(result.benchmarks[0].repetitions(), ElementsAre(DoubleEq(1e-8), DoubleEq(2e-8)));
}

TEST(GoogleBenchmarkResult, NameSaysWhichTimeItIs) {
  const StoredResult result = read(
      iteration("a", "1", "2") + "," + iteration("b/real_time", "1", "2") + "," +
      iteration("c/8/manual_time", "1", "0") + "," + iteration("d/real_time/threads:4", "1", "2") +
      "," + iteration("e/process_time", "1", "2") + "," + iteration("real_time/f", "1", "2"));
  std::vector<double> nanoseconds;
  for (const StoredBenchmark& benchmark : result.benchmarks)
    nanoseconds.push_back(1e9 * benchmark.repetitions().at(0));
  EXPECT_THAT(nanoseconds, ElementsAre(DoubleEq(2), DoubleEq(1), DoubleEq(1), DoubleEq(1),
                                       DoubleEq(2), DoubleEq(2)));
}

TEST(GoogleBenchmarkResult, UnitsBecomeSeconds) {
  const StoredResult result =
      read(iteration("n", "1", "3", "ns") + "," + iteration("u", "1", "3", "us") + "," +
           iteration("m", "1", "3", "ms") + "," + iteration("s", "1", "3", "s"));
  std::vector<double> seconds;
  for (const StoredBenchmark& benchmark : result.benchmarks)
    seconds.push_back(benchmark.repetitions().at(0));
  EXPECT_THAT(seconds, ElementsAre(DoubleEq(3e-9), DoubleEq(3e-6), DoubleEq(3e-3), DoubleEq(3.0)));
  EXPECT_THAT(google_complaint(written(iteration("w", "1", "3", "weeks"))),
              HasSubstr("no unit of time"));
}

TEST(GoogleBenchmarkResult, ErrorsAndZerosAreObjectionsWithoutTimes) {
  const StoredResult result =
      read(iteration("bad", "1", "3") +
           R"(,{"name": "bad", "run_name": "bad", "run_type": "iteration", "error_occurred": true,
               "error_message": "wrong \"NaN\" sum", "iterations": 0, "real_time": 0, "cpu_time": 0,
               "time_unit": "ns"},)" +
           iteration("bad", "1", "4") + "," + iteration("empty", "0", "0") +
           R"(,{"name": "left", "run_name": "left", "run_type": "iteration", "skipped": true,
               "skip_message": "no disk"})");
  ASSERT_EQ(result.benchmarks.size(), 3u);
  EXPECT_EQ(result.benchmarks[0].objection, "it says: wrong \"NaN\" sum");
  EXPECT_EQ(result.benchmarks[1].objection, no_time_to_measure);
  EXPECT_THAT(result.benchmarks[2].objection, HasSubstr("no disk"));
  for (const StoredBenchmark& benchmark : result.benchmarks)
    EXPECT_THAT(benchmark.repetitions(), ElementsAre());
}

TEST(GoogleBenchmarkResult, OnlyAggregatesIsSaid) {
  const StoredResult result = read(aggregate("fill", "mean", "15"));
  ASSERT_EQ(result.benchmarks.size(), 1u);
  EXPECT_EQ(result.benchmarks[0].name, "fill");
  EXPECT_TRUE(result.benchmarks[0].is_aggregate_only);
}

TEST(GoogleBenchmarkResult, KeepsTheMachineButNotItsName) {
  const StoredResult result = read("");
  EXPECT_EQ(result.machine.logical_processors, 2);
  EXPECT_EQ(result.machine.mhz, 2450.0);
  EXPECT_EQ(result.machine.library_build, "debug");
  EXPECT_EQ(result.machine.caches, "L1 Data 32768 x 2, L2 Unified 524288 x 2");
  EXPECT_THAT(result.machine.text, HasSubstr("fill_benchmark"));
  EXPECT_THAT(result.machine.text, HasSubstr("0.12"));
  EXPECT_THAT(result.machine.text, Not(HasSubstr("secret")));
  EXPECT_THAT(result.machine.text, Not(HasSubstr("/some")));
}

TEST(GoogleBenchmarkResult, DamageAndImpossibleTimesAreOneLine) {
  for (const char* wrong : {"-1", "NaN", "-Infinity"})
    EXPECT_THAT(google_complaint(written(iteration("a", "1", wrong))),
                StartsWith("g.json: benchmark 'a': a time of"));
  const std::string whole = written(iteration("a", "1", "2"));
  for (const std::string& text :
       {whole.substr(0, whole.size() - 5), written("7"), written(R"({"name": 3})"),
        written(R"({"name": "a", "run_type": "iteration"})"), std::string("{}")}) {
    EXPECT_THAT(google_complaint(text), StartsWith("g.json: ")) << text;
    EXPECT_EQ(google_complaint(text).find('\n'), std::string::npos) << google_complaint(text);
  }
}

}  // namespace
}  // namespace phytobench
