// SPDX-License-Identifier: MIT
#include "core/parallel/for_blocks.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// The blocks in which a range is walked.
std::set<std::pair<std::size_t, std::size_t>> blocks(std::size_t count, int threads) {
  std::set<std::pair<std::size_t, std::size_t>> seen;
  std::mutex guard;
  for_blocks(count, threads, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(guard);
    seen.emplace(begin, end);
  });
  return seen;
}

TEST(ForBlocks, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 3}) {
    for (const std::size_t count : {1u, 511u, 512u, 513u, 5000u}) {
      std::vector<std::atomic<int>> visits(count);
      for_blocks(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      const auto once = std::count_if(visits.begin(), visits.end(),
                                      [](const std::atomic<int>& number) { return number == 1; });
      EXPECT_EQ(static_cast<std::size_t>(once), count) << threads << " threads";
    }
  }
}

TEST(ForBlocks, OfNothingVisitsNothing) {
  for (const int threads : {1, 2, 3})
    for_blocks(0, threads, [](std::size_t begin, std::size_t end) { EXPECT_EQ(begin, end); });
}

TEST(ForBlocks, IsOnePlainCallWithOneThread) {
  const std::set<std::pair<std::size_t, std::size_t>> whole{{0, 5000}};
  EXPECT_EQ(blocks(5000, 1), whole);
}

TEST(ForBlocks, HandsExceptionsToTheCaller) {
  for (const int threads : {1, 2, 3}) {
    const auto fail_at_3000 = [](std::size_t begin, std::size_t end) {
      if (begin <= 3000 && 3000 < end) throw InputError("index 3000");
    };
    EXPECT_THROW(for_blocks(5000, threads, fail_at_3000), InputError) << threads << " threads";
  }
}

TEST(ForBlocks, WorksAgainAfterAnException) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(
        for_blocks(5000, threads, [](std::size_t, std::size_t) { throw InputError("always"); }),
        InputError);
    std::atomic<std::size_t> visited{0};
    for_blocks(5000, threads, [&](std::size_t begin, std::size_t end) { visited += end - begin; });
    EXPECT_EQ(visited.load(), 5000u) << threads << " threads";
  }
}

TEST(ForBlocksLaw, BlocksDoNotDependOnTheThreadCount) {
  const auto two = blocks(5000, 2);
  EXPECT_GT(two.size(), 5u);
  for (const int threads : {3, 4}) EXPECT_EQ(blocks(5000, threads), two) << threads << " threads";
}

TEST(ForTasks, RunsEachTaskOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    for (const std::size_t count : {1u, 2u, 3u, 7u, 512u, 5000u}) {
      std::vector<std::atomic<int>> runs(count);
      for_tasks(count, threads, [&](std::size_t task) {
        ASSERT_LT(task, count);
        ++runs[task];
      });
      const auto once = std::count_if(runs.begin(), runs.end(),
                                      [](const std::atomic<int>& number) { return number == 1; });
      EXPECT_EQ(static_cast<std::size_t>(once), count) << threads << " threads";
    }
  }
}

TEST(ForTasks, OfNothingRunsNothing) {
  for (const int threads : {0, 1, 2, 3})
    for_tasks(0, threads, [&](std::size_t task) {
      ADD_FAILURE() << task << " with " << threads << " threads";
    });
}

TEST(ForTasks, AreAscendingWithOneThread) {
  for (const int threads : {0, 1}) {
    std::vector<std::size_t> order;
    for_tasks(1000, threads, [&](std::size_t task) { order.push_back(task); });
    ASSERT_EQ(order.size(), 1000u);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end())) << threads << " threads";
    EXPECT_EQ(order.back(), 999u);
  }
}

TEST(ForTasks, NeverRunMoreAtOnceThanThreadsAllowed) {
  for (const int threads : {1, 2}) {
    std::atomic<int> running{0}, most{0};
    for_tasks(2000, threads, [&](std::size_t) {
      const int now = ++running;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
      --running;
    });
    EXPECT_GE(most, 1);
    EXPECT_LE(most, threads);
  }
}

TEST(ForTasks, HandExceptionsToTheCaller) {
  for (const int threads : {1, 2, 3})
    for (const std::size_t failing : {0u, 1u, 99u})
      EXPECT_THROW(for_tasks(100, threads,
                             [&](std::size_t task) {
                               if (task == failing) throw InputError("task");
                             }),
                   InputError)
          << threads << " threads, task " << failing;
}

TEST(ForTasks, EndAtTheFirstExceptionWithOneThread) {
  std::size_t last = 0;
  EXPECT_THROW(for_tasks(100, 1,
                         [&](std::size_t task) {
                           last = task;
                           if (task == 40) throw InputError("task 40");
                         }),
               InputError);
  EXPECT_EQ(last, 40u);
}

TEST(ForTasks, WorkAgainAfterAnException) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(for_tasks(100, threads, [](std::size_t) { throw InputError("always"); }),
                 InputError);
    std::atomic<std::size_t> sum{0};
    for_tasks(100, threads, [&](std::size_t task) { sum += task; });
    EXPECT_EQ(sum.load(), 4950u) << threads << " threads";
  }
}

// A task may itself be run in blocks: an engine's layers are.
TEST(ForTasks, MayHoldBlocks) {
  for (const int threads : {1, 2}) {
    std::vector<std::atomic<int>> visits(10 * 2000);
    for_tasks(10, threads, [&](std::size_t task) {
      for_blocks(2000, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[task * 2000 + i];
      });
    });
    EXPECT_TRUE(std::all_of(visits.begin(), visits.end(),
                            [](const std::atomic<int>& number) { return number == 1; }));
  }
}

}  // namespace
}  // namespace phytobench
