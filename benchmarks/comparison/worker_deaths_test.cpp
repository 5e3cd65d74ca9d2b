// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/worker_deaths.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Names = std::vector<std::string>;

/// Attempts in which a worker dies as often as a benchmark says.
class WorkerDeathsOf : public testing::Test {
 protected:
  std::map<std::string, int> dies_ = {};  ///< how often
  bool was_stopped_ = false;
  std::vector<Names> attempts_ = {};
  Names measured_ = {}, refused_ = {}, reasons_ = {};
  WorkerDeaths deaths_;

  void survive(const Names& names) {
    deaths_.survive(
        names, [&](const Names& some) { return attempt(some); },
        [&](const std::string& name, const WorkerDeath& death) {
          refused_.push_back(name);
          reasons_.push_back(death.reason);
        });
  }

 private:
  std::optional<WorkerDeath> attempt(const Names& names) {
    attempts_.push_back(names);
    const auto deadly =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return dies_[name] > 0; });
    if (deadly != names.end()) {
      --dies_[*deadly];
      return WorkerDeath{.reason = "died", .was_stopped = was_stopped_};
    }
    measured_.insert(measured_.end(), names.begin(), names.end());
    return std::nullopt;
  }
};

TEST_F(WorkerDeathsOf, NoneAreOneAttempt) {
  survive({"a", "b"});
  EXPECT_THAT(attempts_, ElementsAre(Names{"a", "b"}));
  survive({});
  EXPECT_EQ(attempts_.size(), 1u);
}

TEST_F(WorkerDeathsOf, ChanceAreSurvivedTogether) {
  dies_ = {{"b", 2}};
  survive({"a", "b"});
  EXPECT_THAT(attempts_, ElementsAre(Names{"a", "b"}, Names{"a", "b"}, Names{"a", "b"}));
  EXPECT_THAT(measured_, ElementsAre("a", "b"));
  EXPECT_THAT(refused_, IsEmpty());
}

TEST_F(WorkerDeathsOf, OneBenchmarkAreItsOwnVerdictAlone) {
  dies_ = {{"b", 1000}};
  survive({"a", "b", "c"});
  EXPECT_THAT(measured_, ElementsAre("a", "c"));
  EXPECT_THAT(refused_, ElementsAre("b"));
  EXPECT_THAT(reasons_, ElementsAre("died; it happened 3 times"));
  EXPECT_EQ(attempts_.size(), 3u + 1u + 3u + 1u);
}

TEST_F(WorkerDeathsOf, LaterGroupsAreLookedIntoAtOnce) {
  dies_ = {{"b", 3}};
  survive({"a", "b"});
  attempts_.clear();
  dies_ = {{"b", 1}};
  survive({"a", "b"});
  EXPECT_THAT(attempts_, ElementsAre(Names{"a", "b"}, Names{"a"}, Names{"b"}));
  EXPECT_THAT(refused_, IsEmpty());
}

TEST_F(WorkerDeathsOf, TriesOfABenchmarkAreCountedThroughTheWholeMeasurement) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(refused_, IsEmpty());
    dies_ = {{"a", 1}};
    survive({"a"});
  }
  EXPECT_THAT(refused_, ElementsAre("a"));
}

TEST_F(WorkerDeathsOf, HangingAreNotWaitedForAgain) {
  was_stopped_ = true;
  dies_ = {{"b", 1000}};
  survive({"a", "b"});
  EXPECT_THAT(attempts_, ElementsAre(Names{"a", "b"}, Names{"a"}, Names{"b"}));
  EXPECT_THAT(reasons_, ElementsAre("died"));
}

}  // namespace
}  // namespace phytobench
