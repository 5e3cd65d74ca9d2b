// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/counter_gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/text_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string some_inputs(64, 'a');
const std::string other_inputs(64, 'b');

CounterBaseline two_benchmarks() {
  return {{"overlap/sweep/equal", {some_inputs, {{"pairs", 12}, {"tests", 1234567}}}},
          {"nearest-node/voxel_grid/dn", {other_inputs, {{"search_evaluations", 1000}}}}};
}

std::vector<std::string> lines(const CounterBaseline& before, const CounterBaseline& after) {
  std::vector<std::string> texts;
  for (const CounterChange& change : counter_changes(before, after))
    texts.push_back(text_of(change));
  return texts;
}

void expect_counters_refused(const std::string& text, const std::string& problem) {
  try {
    counter_baseline_from(text, "counters.json");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("counters.json: "));
    EXPECT_THAT(error.what(), HasSubstr(problem));
  }
}

/// The file of two_benchmarks() with one place of it replaced.
std::string damaged(const std::string& place, const std::string& by) {
  return replaced(to_json(two_benchmarks()), place, by);
}

TEST(CounterGate, EqualCountersAreNoChange) {
  EXPECT_THAT(counter_changes(two_benchmarks(), two_benchmarks()), IsEmpty());
  EXPECT_THAT(counter_changes({}, {}), IsEmpty());
}

TEST(CounterGate, OneMoreOfAMillionIsAChange) {
  CounterBaseline after = two_benchmarks();
  ++after["overlap/sweep/equal"].counters["tests"];
  EXPECT_THAT(lines(two_benchmarks(), after),
              ElementsAre("overlap/sweep/equal tests 1,234,567 -> 1,234,568 (+8e-05 %)"));
}

TEST(CounterGate, FewerIsAChangeToo) {
  CounterBaseline after = two_benchmarks();
  after["nearest-node/voxel_grid/dn"].counters["search_evaluations"] = 950;
  EXPECT_THAT(lines(two_benchmarks(), after),
              ElementsAre("nearest-node/voxel_grid/dn search_evaluations 1,000 -> 950 (-5.0 %)"));
}

TEST(CounterGate, SaysWhatAppearedAndWhatIsGone) {
  CounterBaseline after = two_benchmarks();
  after.erase("nearest-node/voxel_grid/dn");
  after["new/one"] = {some_inputs, {{"x", 1}}};
  WorkCounts& counters = after["overlap/sweep/equal"].counters;
  counters.erase("pairs");
  counters["areas"] = 0;
  EXPECT_THAT(lines(two_benchmarks(), after),
              ElementsAre("nearest-node/voxel_grid/dn is gone", "new/one is new",
                          "overlap/sweep/equal areas is new: 0",
                          "overlap/sweep/equal pairs is gone; it was 12"));
}

TEST(CounterGate, OtherInputsAreAChangeEvenWithEqualCounters) {
  CounterBaseline after = two_benchmarks();
  after["overlap/sweep/equal"].inputs = other_inputs;
  EXPECT_THAT(lines(two_benchmarks(), after), ElementsAre(HasSubstr("has other inputs")));
}

TEST(CounterGate, FromNothingHasNoPercentage) {
  const CounterBaseline before = {{"a", {some_inputs, {{"copies", 0}}}}};
  const CounterBaseline after = {{"a", {some_inputs, {{"copies", 7}}}}};
  EXPECT_THAT(lines(before, after), ElementsAre("a copies 0 -> 7 (there was none)"));
}

TEST(CounterGate, GroupsDigits) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1000), "1,000");
  EXPECT_EQ(with_thousands(18446744073709551615u), "18,446,744,073,709,551,615");
}

TEST(CounterGate, AWrongAnswerIsNotCounted) {
  const VerifiedBenchmark right{
      .name = "a", .inputs = some_inputs, .answer = "", .objection = "", .work = {{"x", 1}}};
  EXPECT_EQ(counted({right}, "worker"), (CounterBaseline{{"a", {some_inputs, {{"x", 1}}}}}));
  VerifiedBenchmark wrong = right;
  wrong.objection = "node 3 instead of 2";
  EXPECT_THAT(wrong_answers({right, wrong}), ElementsAre("a: node 3 instead of 2"));
  EXPECT_THROW(counted({wrong}, "worker"), ContractViolation);
  VerifiedBenchmark idle = right;
  idle.work.clear();
  EXPECT_THROW(counted({idle}, "worker"), InputError);
  EXPECT_THROW(counted({right, right}, "worker"), InputError);
}

TEST(CounterFile, IsReadAsItWasWritten) {
  EXPECT_EQ(counter_baseline_from(to_json(two_benchmarks()), "f"), two_benchmarks());
  EXPECT_EQ(counter_baseline_from(to_json(CounterBaseline{}), "f"), CounterBaseline{});
  const CounterBaseline largest = {{"a", {some_inputs, {{"x", 18446744073709551615u}}}}};
  EXPECT_EQ(counter_baseline_from(to_json(largest), "f"), largest);
}

TEST(CounterFile, IsSortedWithOneCounterALine) {
  EXPECT_EQ(to_json(two_benchmarks()),
            "{\n  \"schema\": \"phytobench/counters-1\",\n  \"benchmarks\": {\n"
            "    \"nearest-node/voxel_grid/dn\": {\n      \"inputs\": \"" +
                other_inputs +
                "\",\n      \"counters\": {\n        \"search_evaluations\": 1000\n      }\n"
                "    },\n    \"overlap/sweep/equal\": {\n      \"inputs\": \"" +
                some_inputs +
                "\",\n      \"counters\": {\n        \"pairs\": 12,\n        \"tests\": 1234567\n"
                "      }\n    }\n  }\n}\n");
}

TEST(CounterFile, KeepsTheBuildThatWasCounted) {
  const CounterDocument document{.origin = SideOrigin{.given = "build/counters",
                                                      .kind = "build",
                                                      .commit = "0123456789ab",
                                                      .changed = true,
                                                      .compiler = "GNU 12",
                                                      .flags = "-O3"},
                                 .benchmarks = two_benchmarks()};
  const CounterDocument read = counter_document_from(to_json(document), "f");
  ASSERT_TRUE(read.origin);
  EXPECT_EQ(read.origin->commit, "0123456789ab");
  EXPECT_TRUE(read.origin->changed);
  EXPECT_EQ(read.origin->compiler, "GNU 12");
  EXPECT_EQ(read.benchmarks, two_benchmarks());
  EXPECT_FALSE(counter_document_from(to_json(two_benchmarks()), "f").origin);
  std::string damaged_origin = to_json(document);
  damaged_origin.replace(damaged_origin.find("\"0123456789ab\""), 14, "7");
  expect_counters_refused(damaged_origin, "\"origin\" is damaged");
}

TEST(CounterFile, DamageIsNamed) {
  expect_counters_refused("", "is not JSON");
  expect_counters_refused("[]", "schema");
  expect_counters_refused("{}", "schema");
  expect_counters_refused(R"({"schema": "phytobench/counters-1"})", "benchmarks");
  expect_counters_refused(damaged("counters-1", "counters-2"), "schema");
  expect_counters_refused(damaged("1234567", "-1"), "tests of 'overlap/sweep/equal'");
  expect_counters_refused(damaged("1234567", "1.5"), "no whole number");
  expect_counters_refused(damaged("1234567", "\"7\""), "no whole number");
  expect_counters_refused(damaged(some_inputs, "abc"), "inputs");
  expect_counters_refused(damaged("\"counters\"", "\"counter\""), "has no \"counters\"");
  expect_counters_refused(to_json(two_benchmarks()).substr(0, 100), "breaks off");
}

TEST(CountingWorker, OfAnotherBuildIsRefused) {
  const SideOrigin worker{.given = "build/counters", .commit = "aaaaaaaaaaaa"};
  EXPECT_NO_THROW(refuse_stale_worker(worker, {.commit = "aaaaaaaaaaaa"}));
  const auto complaint = [&](const SideOrigin& program) -> std::string {
    try {
      refuse_stale_worker(worker, program);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(complaint({.commit = "bbbbbbbbbbbb"}),
              testing::AllOf(StartsWith("build/counters: "), HasSubstr("from commit aaaaaaaaaaaa,"),
                             HasSubstr("from commit bbbbbbbbbbbb;"),
                             HasSubstr("cmake --build --preset counters")));
  EXPECT_THAT(complaint({.commit = "aaaaaaaaaaaa", .changed = true}),
              HasSubstr("aaaaaaaaaaaa with changes;"));
  EXPECT_THAT(complaint({}), HasSubstr("an unknown commit"));
}

TEST(CounterFile, WhatAMergeLeftTwiceIsRefused) {
  expect_counters_refused(damaged("\"pairs\": 12,", "\"pairs\": 11,\n        \"pairs\": 12,"),
                          "twice");
  expect_counters_refused(to_json(two_benchmarks()) + "\n", "as the program writes it");
}

}  // namespace
}  // namespace phytobench
