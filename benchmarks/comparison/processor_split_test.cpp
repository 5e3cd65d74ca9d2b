// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/processor_split.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(ProcessorSplit, NeedsTwoProcessors) {
  EXPECT_FALSE(processor_split({}));
  EXPECT_FALSE(processor_split({3}));
}

TEST(ProcessorSplit, GivesTheLastToTheWorker) {
  const auto split = processor_split({2, 3, 7});
  ASSERT_TRUE(split);
  EXPECT_EQ(split->runner, 2);
  EXPECT_EQ(split->worker, 7);
}

TEST(PinnedThread, GoesBackToWhereItWas) {
  const std::vector<int> before = allowed_processors();
  ASSERT_FALSE(before.empty());
  {
    const PinnedThread pinned(before.back());
    EXPECT_EQ(allowed_processors(), std::vector<int>{before.back()});
  }
  EXPECT_EQ(allowed_processors(), before);
}

TEST(PinnedThread, StaysWhereItIsWithoutAProcessorOrWithAWrongOne) {
  const std::vector<int> before = allowed_processors();
  const PinnedThread nowhere(std::nullopt), wrong(1000);
  EXPECT_EQ(allowed_processors(), before);
}

}  // namespace
}  // namespace phytobench
