// SPDX-License-Identifier: MIT
// Every benchmark of every family, one after the other: a new one needs no test of its own.
#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "benchmarks/regression/watched_benchmarks.hpp"

namespace phytobench {
namespace {

/// The engines of benchmarks/faulty_engines/ and its like join the registries of this program.
bool is_wrong_on_purpose(const WatchedBenchmark& benchmark) {
  return benchmark.summary.find("Wrong on purpose") != std::string::npos;
}

/// "nearest-node/added" of "nearest-node/added/dn".
std::string family_and_engine(const std::string& name) {
  return name.substr(0, name.find('/', name.find('/') + 1));
}

class WatchedFamilyOracle : public testing::TestWithParam<const BenchmarkFamily*> {
 protected:
  std::vector<WatchedBenchmark> benchmarks() const { return GetParam()->list({}); }
};

TEST_P(WatchedFamilyOracle, AnswersAreRight) {
  for (const WatchedBenchmark& benchmark : benchmarks()) {
    if (is_wrong_on_purpose(benchmark)) continue;
    const auto kernel = benchmark.prepare();
    kernel->run();
    EXPECT_EQ(kernel->objection(), "") << benchmark.name;
  }
}

TEST_P(WatchedFamilyOracle, NoAnswerIsRefused) {
  for (const WatchedBenchmark& benchmark : benchmarks())
    EXPECT_NE(benchmark.prepare()->objection(), "") << benchmark.name << " has not run";
}

TEST_P(WatchedFamilyOracle, EnginesThatAreWrongOnPurposeAreRefused) {
  std::set<std::string> wrong, refused;  // by what comes before the workload
  for (const WatchedBenchmark& benchmark : benchmarks()) {
    if (!is_wrong_on_purpose(benchmark)) continue;
    const std::string engine = family_and_engine(benchmark.name);
    wrong.insert(engine);
    const auto kernel = benchmark.prepare();
    kernel->run();
    if (!kernel->objection().empty()) refused.insert(engine);
  }
  EXPECT_EQ(refused, wrong) << "on at least one of its workloads";
  const std::string_view family = GetParam()->name;
  const std::size_t made = family == "nearest_node" || family == "overlap" ? 4
                           : family == "shadow"                            ? 3
                                                                           : 0;
  EXPECT_EQ(wrong.size(), made);
}

TEST_P(WatchedFamilyOracle, EveryRunAndPreparationGivesTheSame) {
  for (const WatchedBenchmark& benchmark : benchmarks()) {
    const auto first = benchmark.prepare(), second = benchmark.prepare();
    first->run();
    const std::string inputs = first->inputs(), answer = first->answer();
    const WorkCounts work = first->work();
    first->run();
    second->run();
    for (const auto& kernel : {first.get(), second.get()}) {
      EXPECT_EQ(kernel->inputs(), inputs) << benchmark.name;
      EXPECT_EQ(kernel->answer(), answer) << benchmark.name;
      EXPECT_EQ(kernel->work(), work) << benchmark.name;
    }
    EXPECT_EQ(inputs.size(), 64u) << benchmark.name;
    EXPECT_EQ(answer.size(), 64u) << benchmark.name;
    EXPECT_NE(inputs, answer) << benchmark.name;
  }
}

TEST_P(WatchedFamilyOracle, WorkIsCounted) {
  for (const WatchedBenchmark& benchmark : benchmarks()) {
    const auto kernel = benchmark.prepare();
    kernel->run();
    const WorkCounts work = kernel->work();
    EXPECT_TRUE(std::any_of(work.begin(), work.end(), [](const auto& counter) {
      return counter.second > 0;
    })) << benchmark.name;
    for (const auto& [counter, count] : work)
      EXPECT_LT(count, std::uint64_t{1} << 40) << benchmark.name << ": " << counter;
  }
}

INSTANTIATE_TEST_SUITE_P(All, WatchedFamilyOracle, testing::ValuesIn(benchmark_families()),
                         [](const auto& tested) { return std::string(tested.param->name); });

}  // namespace
}  // namespace phytobench
