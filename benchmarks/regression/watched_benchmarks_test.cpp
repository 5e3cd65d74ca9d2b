// SPDX-License-Identifier: MIT
#include "benchmarks/regression/watched_benchmarks.hpp"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using Names = std::vector<std::string>;

Names names_of(const std::vector<WatchedBenchmark>& benchmarks) {
  Names names;
  for (const WatchedBenchmark& benchmark : benchmarks) names.push_back(benchmark.name);
  return names;
}

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Error>
std::string message_for(const Names& globs) {
  try {
    chosen_benchmarks(watched_benchmarks(), globs);
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error";
}

TEST(WatchedBenchmarks, AreNamedUniquelyAndSummarised) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789./_-";
  std::set<std::string> names;
  for (const WatchedBenchmark& benchmark : watched_benchmarks()) {
    EXPECT_TRUE(names.insert(benchmark.name).second) << benchmark.name;
    EXPECT_EQ(benchmark.name.find_first_not_of(letters), std::string::npos) << benchmark.name;
    EXPECT_NE(benchmark.name.find('/'), std::string::npos) << benchmark.name;
    EXPECT_TRUE(benchmark.summary.ends_with('.')) << benchmark.name;
    EXPECT_TRUE(benchmark.prepare) << benchmark.name;
  }
}

TEST(WatchedBenchmarks, ComeFromAllFamilies) {
  std::size_t sum = 0;
  std::set<std::string_view> families;
  for (const BenchmarkFamily* family : benchmark_families()) {
    EXPECT_TRUE(families.insert(family->name).second) << family->name;
    EXPECT_TRUE(family->summary.ends_with('.')) << family->name;
    const std::size_t size = family->list({}).size();
    EXPECT_GT(size, 0u) << family->name;
    sum += size;
  }
  EXPECT_EQ(families.size(), 8u);
  EXPECT_EQ(watched_benchmarks().size(), sum);
}

TEST(WatchedBenchmarks, HoldEveryBuiltEngineAndSayWhoseItIs) {
  const std::vector<WatchedBenchmark> all = watched_benchmarks();
  for (const EngineDescriptor* engine : all_engines()) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const WatchedBenchmark& one) {
      return one.name == "nearest-node/" + std::string(engine->name) + "/dn";
    });
    ASSERT_EQ(found != all.end(), engine->built()) << engine->name;
    if (engine->built()) EXPECT_EQ(found->is_own, engine->library.empty()) << engine->name;
  }
  EXPECT_TRUE(has(names_of(all), "nearest-node/node_driven/s"));
  EXPECT_TRUE(has(names_of(all), "overlap/layered_grid"));
  EXPECT_TRUE(has(names_of(all), "competition/symmetric"));
  EXPECT_FALSE(has(names_of(all), "competition/none")) << "it has no work";
}

TEST(WatchedBenchmarks, TakeInAnEngineFromElsewhere) {
  EngineDescriptor added = engine_named("squared_scan");
  added.name = "added";
  const Names names = names_of(watched_benchmarks({.extra_engines = {&added}}));
  EXPECT_EQ(names.size(), watched_benchmarks().size() + 2);
  EXPECT_TRUE(has(names, "nearest-node/added/dn"));
  EXPECT_TRUE(has(names, "nearest-node/added/ties"));
}

TEST(WatchedBenchmarks, RefuseAnEngineWithTheNameOfAnother) {
  const EngineDescriptor copy = engine_named("squared_scan");
  try {
    watched_benchmarks({.extra_engines = {&copy}});
    FAIL() << "two benchmarks of one name";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nearest-node/squared_scan/dn"));
  }
}

TEST(ChosenBenchmarks, FollowNamesAndGlobs) {
  const std::vector<WatchedBenchmark> all = watched_benchmarks();
  EXPECT_EQ(names_of(chosen_benchmarks(all, {})), names_of(all));
  EXPECT_EQ(names_of(chosen_benchmarks(all, {"tree/skeleton-to-mesh", "overlap/sweep"})),
            (Names{"overlap/sweep", "tree/skeleton-to-mesh"}));
  EXPECT_EQ(names_of(chosen_benchmarks(all, {"nearest-node/node_driven/*"})),
            (Names{"nearest-node/node_driven/dn", "nearest-node/node_driven/s",
                   "nearest-node/node_driven/ties"}));
  EXPECT_EQ(names_of(chosen_benchmarks(all, {"nearest-node/node_driven/?"})),
            Names{"nearest-node/node_driven/s"});
}

TEST(ChosenBenchmarks, SayWhatWasMeantOrThatNothingMatches) {
  EXPECT_THAT(message_for<InputError>({"overlap/layerd_grid"}), HasSubstr("overlap/layered_grid"));
  EXPECT_THAT(message_for<NothingSelected>({"nearest-tree/*"}), HasSubstr("'nearest-tree/*'"));
}

}  // namespace
}  // namespace phytobench
