// SPDX-License-Identifier: MIT
#include "core/nearest_node/plugin/floating_point_control.hpp"

#include <cfenv>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(FloatingPointControl, SeesAnotherRoundingAndTakesItBack) {
  const FloatingPointControl usual;
  EXPECT_TRUE(usual.is_in_force());
  std::fesetround(FE_UPWARD);
  EXPECT_FALSE(usual.is_in_force());
  usual.restore();
  EXPECT_TRUE(usual.is_in_force());
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(FloatingPointControl, DoesNotMindFlags) {
  const FloatingPointControl usual;
  std::feraiseexcept(FE_INEXACT | FE_DIVBYZERO);
  EXPECT_TRUE(usual.is_in_force());
  usual.restore();
  EXPECT_NE(std::fetestexcept(FE_DIVBYZERO), 0) << "a flag is gone";
  std::feclearexcept(FE_ALL_EXCEPT);
}

#ifdef __SSE__
TEST(FloatingPointControl, SeesFlushedNumbersAndUnmaskedExceptions) {
  constexpr unsigned int denormals_are_zero = 0x40, flush_to_zero = 0x8000,
                         no_division_mask = 0x200;
  const FloatingPointControl usual;
  const unsigned int before = _mm_getcsr();
  for (const unsigned int bit : {denormals_are_zero, flush_to_zero, no_division_mask}) {
    _mm_setcsr(before ^ bit);
    EXPECT_FALSE(usual.is_in_force()) << bit;
    usual.restore();
    EXPECT_TRUE(usual.is_in_force()) << bit;
  }
}
#endif

}  // namespace
}  // namespace phytobench
