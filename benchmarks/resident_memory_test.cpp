// SPDX-License-Identifier: MIT
#include "benchmarks/resident_memory.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(ResidentMemory, ThePeakRemembersWhatWasGivenBack) {
  if (!resident_bytes() || !reset_peak_memory()) GTEST_SKIP() << "the system does not tell";
  constexpr std::int64_t size = 64 << 20;
  const std::int64_t before = *resident_bytes();
  { const std::vector<char> large(static_cast<std::size_t>(size), 'x'); }
  EXPECT_GE(*peak_resident_bytes() - before, size * 9 / 10);
  ASSERT_TRUE(reset_peak_memory());
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(*peak_resident_bytes() - before, size / 2);
#endif
}

}  // namespace
}  // namespace phytobench
