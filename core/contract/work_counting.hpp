// SPDX-License-Identifier: MIT
// Work that is independent of the machine is counted. What would cost time to count is counted by
// policy: in the preset `counters`, and nowhere else.
#pragma once

#include <cstdint>

#include "counting_policy.hpp"

namespace phytobench {

/// Counters inside the innermost loop cost time, so they exist only in the `counters` preset.
inline constexpr bool counts_inner_loop = PHYTOBENCH_COUNTS_WORK != 0;

/// A counter for innermost loops: in other presets it stays 0, and counting compiles to nothing.
class InnerLoopCounter {
 public:
  void add(std::uint64_t more) {
    if constexpr (counts_inner_loop) count_ += more;
  }
  std::uint64_t count() const { return count_; }

 private:
  std::uint64_t count_ = 0;
};

}  // namespace phytobench
