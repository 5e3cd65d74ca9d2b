// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/stored_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/text_fixture.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

StoredResult some_result() {
  return {.origin = {.given = "build/new",
                     .kind = "build",
                     .commit = "abc",
                     .changed = true,
                     .compiler = "GNU 12",
                     .flags = "-O3",
                     .program_digest = "ff"},
          .machine = {.processor = "Model 1", .logical_processors = 2, .kernel = "Linux 6"},
          .seed = 7,
          .reference = ReferenceTime{.name = "reference kernel", .seconds = 0.5},
          .benchmarks = {{.name = "a/one",
                          .inputs = "i",
                          .answer = "w",
                          .processes = {{0.1, 0.3, 0.2}, {0.4}},
                          .is_by_process = true},
                         {.name = "a/two",
                          .inputs = "j",
                          .objection = "node 3 instead of 2",
                          .is_by_process = true}}};
}

std::string stored_complaint(const std::string& json) {
  return input_error([&] { stored_result_from(json, "r.json"); });
}

TEST(StoredResult, ComesBackAsItWasWritten) {
  const StoredResult read = stored_result_from(to_json(some_result()), "r.json");
  EXPECT_EQ(read.origin.given, "r.json");
  EXPECT_EQ(read.origin.kind, "result");
  EXPECT_EQ(read.origin.commit, "abc");
  EXPECT_TRUE(read.origin.changed);
  EXPECT_EQ(read.origin.program_digest, "");
  EXPECT_EQ(read.machine.processor, "Model 1");
  EXPECT_EQ(read.machine.logical_processors, 2);
  EXPECT_EQ(read.seed, 7u);
  ASSERT_TRUE(read.reference.has_value());
  EXPECT_EQ(read.reference->seconds, 0.5);
  ASSERT_EQ(read.benchmarks.size(), 2u);
  EXPECT_THAT(read.benchmarks[0].processes,
              ElementsAre(ElementsAre(0.1, 0.3, 0.2), ElementsAre(0.4)));
  EXPECT_EQ(read.benchmarks[1].objection, "node 3 instead of 2");
  StoredResult again = read;
  again.origin = some_result().origin;
  EXPECT_EQ(to_json(again), to_json(some_result()));
}

TEST(StoredResult, RepetitionIsAProcessWhereProcessesAreKnown) {
  StoredBenchmark benchmark = some_result().benchmarks[0];
  EXPECT_THAT(benchmark.repetitions(), ElementsAre(0.2, 0.4));
  benchmark.is_by_process = false;
  EXPECT_THAT(benchmark.repetitions(), ElementsAre(0.1, 0.3, 0.2, 0.4));
}

TEST(StoredResult, ImpossibleTimesAreRefused) {
  const std::string json = to_json(some_result());
  for (const char* wrong : {"-0.4", "0", "NaN", "Infinity", "null"})
    EXPECT_THAT(stored_complaint(replaced(json, "0.4", wrong)),
                StartsWith("r.json: benchmark 'a/one': a time of"))
        << wrong;
  EXPECT_THAT(stored_complaint(replaced(json, "\"seconds\": 0.5", "\"seconds\": 0.0")),
              HasSubstr("reference 'reference kernel'"));
  EXPECT_THAT(stored_complaint(replaced(json, "a/two", "a/one")), HasSubstr("is there twice"));
}

TEST(StoredResult, DamageIsOneLine) {
  const std::string json = to_json(some_result());
  for (const std::string& text :
       {json.substr(0, json.size() / 2), replaced(json, "\"commit\"", "\"comit\""),
        replaced(json, "\"seed\": 7", "\"seed\": \"x\""), replaced(json, "[\n", "{\n"),
        std::string("[]")}) {
    EXPECT_THAT(stored_complaint(text), StartsWith("r.json: "));
    EXPECT_EQ(stored_complaint(text).find('\n'), std::string::npos) << stored_complaint(text);
  }
}

class ResultFile : public RunFolder {
 protected:
  std::string complaint_about(const std::string& text) const {
    const std::filesystem::path file = base_ / "r.json";
    write_file_atomically(file, text);
    return input_error([&] { read_stored_result(file); });
  }
};

TEST_F(ResultFile, IsReadByItsContent) {
  const std::filesystem::path file = base_ / "r.json";
  write_file_atomically(file, to_json(some_result()));
  EXPECT_EQ(read_stored_result(file).benchmarks.size(), 2u);
  write_file_atomically(file, R"({"context": {"num_cpus": 2}, "benchmarks": []})");
  EXPECT_EQ(read_stored_result(file).machine.logical_processors, 2);
}

TEST_F(ResultFile, WhatIsNoResultIsToldWhatIs) {
  EXPECT_THAT(complaint_about(R"({"schema": "phytobench/comparison-1"})"),
              HasSubstr("is an earlier comparison"));
  EXPECT_THAT(complaint_about(R"({"schema": "phytobench/counters-1"})"),
              HasSubstr("history append"));
  for (const char* text : {"", " \n", "{}", "[1]", "x,y\n1,2\n", R"({"schema": "other"})"})
    EXPECT_THAT(complaint_about(text), HasSubstr("--benchmark_out_format=json")) << text;
  EXPECT_THAT(input_error([&] { read_stored_result(base_ / "none.json"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace phytobench
