// SPDX-License-Identifier: MIT
// Code is broken on purpose, in four ways, and each time a gate must see it: with the machinery
// that ./check uses, on engines that run.
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/broken/broken_engines.hpp"
#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/comparison/found_program.hpp"
#include "benchmarks/comparison/instruction_gate.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "benchmarks/regression/sampling.hpp"
#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

const std::string whole_scan = "nearest-node/blocked_scan/dn";
const std::string watched_name = "nearest-node/some_engine/dn";

WatchedBenchmark benchmark_named(const std::string& name) {
  const auto all = watched_benchmarks({.extra_engines = broken_engines()});
  return chosen_benchmarks(all, {name}).front();
}

/// What a run of the benchmark has to show, as if it were the same engine in each version.
VerifiedBenchmark run_of(const std::string& name) {
  VerifiedBenchmark verified = verify_benchmark(benchmark_named(name));
  if (verified.work.empty()) {  // a build that is timed counts less, but these it always counts
    const auto kernel = benchmark_named(name).prepare();
    kernel->run();
    verified.work = kernel->work();
  }
  verified.name = watched_name;
  return verified;
}

/// The gate on counters: a file is written from the engine before, and the engine after is held
/// against it.
std::vector<std::string> counter_gate(const VerifiedBenchmark& before,
                                      const VerifiedBenchmark& after) {
  const fs::path file = fs::path(testing::TempDir()) /
                        ("phytobench-counters-" + std::to_string(::getpid()) + ".json");
  write_file_atomically(file, to_json(counted({before}, "before")));
  const CounterBaseline baseline = counter_baseline_from(read_text_file(file), file.string());
  fs::remove(file);
  std::vector<std::string> lines;
  for (const CounterChange& change : counter_changes(baseline, counted({after}, "after")))
    lines.push_back(text_of(change));
  return lines;
}

double share_of(const VerifiedBenchmark& after, const VerifiedBenchmark& before,
                const std::string& counter) {
  return static_cast<double>(after.work.at(counter)) / static_cast<double>(before.work.at(counter));
}

TEST(GateBreakage, TheSameEngineAgainPasses) {
  const VerifiedBenchmark before = run_of(whole_scan), after = run_of(whole_scan);
  EXPECT_EQ(before.objection, "");
  EXPECT_EQ(before.answer, after.answer);
  EXPECT_THAT(counter_gate(before, after), IsEmpty());
}

TEST(GateBreakage, FivePercentMoreEvaluationsAreSeenByTheCounters) {
  const VerifiedBenchmark before = run_of(whole_scan),
                          after = run_of("nearest-node/looks_twice/dn");
  EXPECT_EQ(after.objection, "") << "the answer is still right";
  const double evaluations = static_cast<double>(before.work.at("search_evaluations"));
  EXPECT_GT(evaluations, 10000.0);
  // Every twentieth; a run may begin in the midst of twenty.
  EXPECT_NEAR(share_of(after, before, "search_evaluations"), 1.05, 1.0 / evaluations);
  EXPECT_THAT(
      counter_gate(before, after),
      testing::Contains(testing::AllOf(HasSubstr("search_evaluations"), HasSubstr("(+5.0 %)"))));
}

TEST(GateBreakage, ARemovedPruningStepIsSeenByTheCounters) {
  const VerifiedBenchmark before = run_of(whole_scan),
                          after = run_of("nearest-node/never_prunes/dn");
  EXPECT_EQ(after.objection, "") << "the answer is still right";
  EXPECT_GT(share_of(after, before, "search_evaluations"), 1.05);
  EXPECT_THAT(counter_gate(before, after), testing::Contains(HasSubstr("search_evaluations")));
}

/// Counts of the preset 'counters', which alone counts allocations: by this program if it is one of
/// that preset, else by the worker that cmake/check-gates builds before ./check runs tests. Nothing
/// where that is not built.
std::optional<VerifiedBenchmark> counted_run_of(const std::string& name) {
  if (counts_inner_loop) return run_of(name);
  if (!found_program(PHYTOBENCH_COUNTING_BROKEN_WORKER)) return std::nullopt;
  Side counting;
  counting.origin.given = "the worker that counts";
  counting.origin.kind = "build";
  counting.worker = PHYTOBENCH_COUNTING_BROKEN_WORKER;
  counting.data_folder = data_folder();
  WorkerClient worker(counting);
  VerifiedBenchmark counted = worker.counters({name}).front();
  counted.name = watched_name;
  return counted;
}

TEST(GateBreakage, ACopyPerQueryIsSeenByTheAllocations) {
  const auto before = counted_run_of(whole_scan),
             after = counted_run_of("nearest-node/copies_nodes/dn");
  if (!before || !after)
    GTEST_SKIP() << "allocations are counted in the preset 'counters' only; build it with "
                    "cmake/check-gates";
  EXPECT_EQ(before->objection, "");
  EXPECT_EQ(after->objection, "") << "the answer is still right";
  EXPECT_GE(after->work.at("allocations"),
            before->work.at("allocations") + after->work.at("queries"));
  EXPECT_THAT(counter_gate(*before, *after), testing::Contains(HasSubstr("allocations")));
}

TEST(GateBreakage, ACopyPerQueryIsNotSeenByAnyOtherCounter) {
  VerifiedBenchmark before = run_of(whole_scan), after = run_of("nearest-node/copies_nodes/dn");
  for (VerifiedBenchmark* run : {&before, &after})
    for (const char* counter : {"allocations", "allocated_bytes"}) run->work.erase(counter);
  EXPECT_THAT(counter_gate(before, after), IsEmpty());
}

TEST(GateBreakage, AnotherTieRuleIsRefusedByTheOracle) {
  const auto all = watched_benchmarks({.extra_engines = broken_engines()});
  std::size_t refused = 0;
  for (const WatchedBenchmark& benchmark :
       chosen_benchmarks(all, {"nearest-node/prefers_newer/*"})) {
    const VerifiedBenchmark wrong = verify_benchmark(benchmark);
    if (wrong.objection.empty()) continue;
    ++refused;
    EXPECT_THAT(wrong_answers({wrong}), testing::ElementsAre(HasSubstr(benchmark.name)));
    std::string unbroken = benchmark.name;
    unbroken.replace(unbroken.find("prefers_newer"), 13, "blocked_scan");
    const VerifiedBenchmark right = verify_benchmark(benchmark_named(unbroken));
    EXPECT_EQ(right.objection, "");
    EXPECT_EQ(right.inputs, wrong.inputs);
  }
  EXPECT_GT(refused, 0u) << "no watched growth has two nodes equally near to a point";
}

/// Real counts of real programs.
class CallgrindGateSlow : public testing::Test {
 protected:
  void SetUp() override {
    if (is_sanitized) GTEST_SKIP() << "Valgrind cannot run what the address sanitizer has built";
    if (!found_program("valgrind")) GTEST_SKIP() << "valgrind is not installed";
  }

  static InstructionCount count_of(const std::string& benchmark,
                                   const fs::path& worker = PHYTOBENCH_BROKEN_WORKER) {
    const InstructionCount count =
        count_instructions({.worker = worker, .data = data_folder(), .benchmark = benchmark});
    EXPECT_EQ(count.outcome, CountOutcome::counted) << count.reason;
    EXPECT_GT(count.totals.instructions, 100000u);
    return count;
  }

  static JudgedInstructions judged(const InstructionCount& before, const InstructionCount& after) {
    CountedPair pair{.benchmark = watched_name};
    pair.base = before;
    pair.other = after;
    return judge_instructions(pair, {}, "0123456789ab");
  }
};

TEST_F(CallgrindGateSlow, CountsOfOneProgramAgreeWhereverItLies) {
  const fs::path folder =
      fs::path(testing::TempDir()) /
      ("phytobench-a-folder-with-a-much-longer-name-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  fs::copy_file(PHYTOBENCH_BROKEN_WORKER, folder / "worker", fs::copy_options::overwrite_existing);
  const InstructionCount first = count_of(whole_scan), again = count_of(whole_scan),
                         elsewhere = count_of(whole_scan, folder / "worker");
  fs::remove_all(folder);
  // Not to the last instruction: up to a thousand of 27 million were seen to come and go. The gate
  // notes twenty times as much.
  const auto instructions = static_cast<double>(first.totals.instructions);
  for (const InstructionCount* count : {&again, &elsewhere})
    EXPECT_NEAR(static_cast<double>(count->totals.instructions), instructions, 1e-4 * instructions);
  EXPECT_EQ(first.inputs, elsewhere.inputs);
  EXPECT_EQ(judged(first, again).verdict, InstructionVerdict::same);
}

TEST_F(CallgrindGateSlow, ACopyPerQueryIsSeenByTheInstructions) {
  const InstructionCount before = count_of(whole_scan),
                         after = count_of("nearest-node/copies_nodes/dn");
  EXPECT_EQ(before.answer, after.answer) << "the answer is still right";
  const JudgedInstructions verdict = judged(before, after);
  EXPECT_EQ(verdict.verdict, InstructionVerdict::more);
  EXPECT_TRUE(is_failure(verdict.verdict));
  EXPECT_GT(verdict.change.value_or(0.0), 0.01);
}

TEST_F(CallgrindGateSlow, WhatIsNotThereIsAFailure) {
  const InstructionCount count = count_instructions({.worker = PHYTOBENCH_BROKEN_WORKER,
                                                     .data = data_folder(),
                                                     .benchmark = "nearest-node/nobody/dn"});
  EXPECT_EQ(count.outcome, CountOutcome::failed);
  EXPECT_THAT(count.reason, HasSubstr("nobody"));
}

}  // namespace
}  // namespace phytobench
