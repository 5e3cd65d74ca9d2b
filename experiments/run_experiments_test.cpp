// SPDX-License-Identifier: MIT
#include "experiments/run_experiments.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t large_bytes = std::size_t{192} << 20;

void count(ExperimentContext& context) {
  context.progress("counting");
  context.record("count", std::int64_t{3});
  context.timing("step", 0, 0, 0.5);
  context.artifact("tree.svg", "<svg/>");
}

/// Touches much memory of its own and gives it back.
void fill_memory(ExperimentContext& context) {
  void* const memory =
      ::mmap(nullptr, large_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  std::memset(memory, 1, large_bytes);
  ::munmap(memory, large_bytes);
  context.record("bytes", static_cast<std::int64_t>(large_bytes));
}

void find_disk_full(ExperimentContext&) {
  throw EnvironmentError("disk full");
}

constexpr ExperimentDescriptor descriptor(std::string_view id, void (*run)(ExperimentContext&)) {
  return {.id = id, .question = "?", .source = "[Fake]", .seconds = {1.0, 30.0, 600.0}, .run = run};
}

constexpr ExperimentDescriptor first = descriptor("fake/first", count);
constexpr ExperimentDescriptor second = descriptor("fake/second", count);
constexpr ExperimentDescriptor large = descriptor("fake/large", fill_memory);
constexpr ExperimentDescriptor failing = descriptor("fake/failing", find_disk_full);

class ExperimentRuns : public testing::Test {
 protected:
  fs::path base_ = fs::path(testing::TempDir()) /
                   ("phytobench_runs_" + std::to_string(::getpid()) + "_" +
                    testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::path folder_ = base_ / "run";
  void SetUp() override { fs::remove_all(base_); }
  void TearDown() override { fs::remove_all(base_); }

  RunRequest request(std::vector<const ExperimentDescriptor*> experiments) const {
    return {.experiments = std::move(experiments),
            .header = {Tier::smoke, 0},
            .threads = 2,
            .folder = folder_,
            .command_line = "test"};
  }

  RunRequest resumed(std::vector<const ExperimentDescriptor*> experiments) const {
    RunRequest again = request(std::move(experiments));
    again.mode = RunMode::resume;
    return again;
  }

  std::vector<TimingSample> timings_named(const std::string& measurement) const {
    std::vector<TimingSample> found = read_run(folder_).timings;
    std::erase_if(found, [&](const auto& sample) { return sample.measurement != measurement; });
    return found;
  }
};

TEST_F(ExperimentRuns, KeepWhatEachExperimentCosts) {
  const RunSummary summary = run_experiments(request({&first, &second}));
  for (const FinishedExperiment& finished : summary.finished) {
    const std::string id(finished.experiment->id);
    const auto seconds = timings_named(id + "/cost/seconds");
    ASSERT_EQ(seconds.size(), 1u);
    EXPECT_EQ(seconds[0].value, finished.cost.seconds);
    EXPECT_GT(seconds[0].value, 0.0);
    EXPECT_EQ(seconds[0].unit, "s");
    EXPECT_EQ(seconds[0].round, 0);
    EXPECT_EQ(seconds[0].threads, 2);
    const auto memory = timings_named(id + "/cost/peak_memory");
    ASSERT_EQ(memory.size(), finished.cost.peak_memory_mib ? 1u : 0u);
    if (memory.empty()) continue;
    EXPECT_EQ(memory[0].value, *finished.cost.peak_memory_mib);
    EXPECT_EQ(memory[0].unit, "MiB");
    EXPECT_EQ(memory[0].round, 0);
  }
}

TEST_F(ExperimentRuns, LeaveTheRecordsAsTheyWouldBeWithoutCosts) {
  run_experiments(request({&first, &second}));
  RunWriter writer(base_ / "plain", {Tier::smoke, 0}, RunMode::fresh);
  for (const char* id : {"fake/first", "fake/second"}) {
    ExperimentContext context(id, Tier::smoke, 0, 1);
    count(context);
    writer.append(id, context.records(), context.timings());
  }
  EXPECT_EQ(read_text_file(folder_ / "records.jsonl"),
            read_text_file(base_ / "plain" / "records.jsonl"));
}

TEST_F(ExperimentRuns, PeakMemoryIsThatOfEachExperiment) {
  const RunSummary summary = run_experiments(request({&large, &first}));
  ASSERT_EQ(summary.finished.size(), 2u);
  const auto before = summary.finished[0].cost.peak_memory_mib;
  const auto after = summary.finished[1].cost.peak_memory_mib;
  if (!before || !after) GTEST_SKIP() << "the system does not reset the high-water mark here";
  EXPECT_GE(*before, 192.0);
  EXPECT_LT(*after, *before - 150.0);
}

TEST_F(ExperimentRuns, SayWhatTheyDid) {
  EXPECT_EQ(run_experiments(request({&first})).skipped, 0u);
  const RunSummary more = run_experiments(resumed({&first, &second}));
  EXPECT_EQ(more.skipped, 1u);
  ASSERT_EQ(more.finished.size(), 1u);
  EXPECT_EQ(more.finished[0].experiment, &second);
  EXPECT_GE(more.seconds, more.finished[0].cost.seconds);
  const std::string environment = read_text_file(folder_ / "environment.json");
  EXPECT_TRUE(run_experiments(resumed({&first, &second})).finished.empty());
  EXPECT_EQ(read_text_file(folder_ / "environment.json"), environment);
}

TEST_F(ExperimentRuns, AnnounceWhatIsCompleteAndWhatIsLeft) {
  run_experiments(request({&first}));
  RunRequest again = resumed({&first, &second});
  TimeEstimate expected(Tier::smoke);
  expected.learn(first, timings_named("fake/first/cost/seconds").at(0).value);
  bool announced = false;
  again.announce = [&](const RunPlan& plan) {
    announced = true;
    EXPECT_THAT(plan.complete, ElementsAre(&first));
    EXPECT_THAT(plan.open, ElementsAre(&second));
    EXPECT_EQ(plan.estimate.seconds_of(second), expected.seconds_of(second));
  };
  run_experiments(again);
  EXPECT_TRUE(announced);
}

TEST_F(ExperimentRuns, ShowPlaceAndTimeLeft) {
  run_experiments(request({&first}));
  RunRequest again = resumed({&first, &second, &large});
  std::vector<std::string> lines;
  again.show_progress = [&](const std::string& line) { lines.push_back(line); };
  run_experiments(again);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_THAT(lines[0], StartsWith("[2/3] "));
  EXPECT_THAT(lines[0], HasSubstr(" s elapsed, about "));
  EXPECT_THAT(lines[0], HasSubstr(" s left: fake/second: starting"));
  EXPECT_THAT(lines[1], HasSubstr("fake/second: counting"));
  EXPECT_THAT(lines[2], StartsWith("[3/3] "));
}

TEST_F(ExperimentRuns, SayWhatAnInterruptionLeaves) {
  RunRequest interrupted = request({&first, &second});
  int asked = 0;
  interrupted.is_interrupted = [&] { return ++asked > 3; };
  try {
    run_experiments(interrupted);
    ADD_FAILURE() << "was not interrupted";
  } catch (const Interrupted& error) {
    EXPECT_THAT(error.what(), HasSubstr("1 of 2 experiments are finished and kept"));
    EXPECT_THAT(error.what(), HasSubstr("--resume"));
  }
  EXPECT_EQ(read_run(folder_).complete_experiments, std::set<std::string>{"fake/first"});
}

TEST_F(ExperimentRuns, KeepWhatWasFinishedBeforeAFailure) {
  EXPECT_THROW(run_experiments(request({&first, &failing, &second})), EnvironmentError);
  EXPECT_EQ(read_run(folder_).complete_experiments, std::set<std::string>{"fake/first"});
  run_experiments(resumed({&first, &second}));
  const std::string records = read_text_file(folder_ / "records.jsonl");
  fs::remove_all(folder_);
  run_experiments(request({&first, &second}));
  EXPECT_EQ(read_text_file(folder_ / "records.jsonl"), records);
}

TEST_F(ExperimentRuns, PlanOfAFolderRefusesAnotherRun) {
  const std::vector<const ExperimentDescriptor*> both{&first, &second};
  EXPECT_EQ(plan_run_in(folder_, both, {Tier::smoke, 0}).open.size(), 2u) << "nothing is there";
  run_experiments(request({&first}));
  EXPECT_EQ(plan_run_in(folder_, both, {Tier::smoke, 0}).open.size(), 1u);
  EXPECT_THROW(plan_run_in(folder_, both, {Tier::smoke, 1}), InputError);
  EXPECT_THROW(plan_run_in(folder_, both, {Tier::quick, 0}), InputError);
}

}  // namespace
}  // namespace phytobench
