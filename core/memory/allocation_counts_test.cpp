// SPDX-License-Identifier: MIT
#include "core/memory/allocation_counts.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/memory/large_array.hpp"
#include "core/nearest_node/work_counters.hpp"

namespace phytobench {
namespace {

const volatile void* seen = nullptr;  ///< what is looked at cannot be left out

/// What `work` asks for.
template <class Work>
AllocationCounts allocations_of(const Work& work) {
  const AllocationCounts before = allocations_so_far();
  work();
  const AllocationCounts after = allocations_so_far();
  return {after.count - before.count, after.bytes - before.bytes};
}

TEST(AllocationCounts, AreTakenOnlyInBuildsThatCount) {
  const AllocationCounts vector = allocations_of([] {
    std::vector<char> memory(1000);
    seen = memory.data();
  });
  const AllocationCounts large = allocations_of([] {
    LargeVector<char> memory(1000);
    seen = memory.data();
  });
  if (counts_inner_loop) {
    EXPECT_EQ(vector.count, 1u);
    EXPECT_EQ(vector.bytes, 1000u);
    EXPECT_EQ(large.count, 1u);
    EXPECT_GE(large.bytes, 1000u);
  } else {
    EXPECT_EQ(vector.count + vector.bytes, 0u);
    EXPECT_EQ(large.count + large.bytes, 0u);
  }
}

TEST(AllocationCounts, NoAllocationCountsNothing) {
  std::vector<int> kept(10);
  EXPECT_EQ(allocations_of([&] { kept.assign(10, 3); }).count, 0u);
}

}  // namespace
}  // namespace phytobench
