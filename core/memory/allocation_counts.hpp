// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace phytobench {

/// Memory asked for since the program started, through operator new and allocate_large(). Whether
/// it was freed does not matter.
struct AllocationCounts {
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
};

/// Zero unless the program was built with counters (counts_inner_loop): counting costs time.
AllocationCounts allocations_so_far();

/// For allocators that operator new does not see.
void note_allocation(std::uint64_t bytes);

}  // namespace phytobench
