// SPDX-License-Identifier: MIT
#include "reports/document_intervals.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(ShownEnds, CallARangeWhatItIs) {
  EXPECT_EQ(shown_ends({{2, 1, 3}, 6}, "1 s", "3 s"), "1 s to 3 s");
  EXPECT_EQ(shown_ends({{2, 1, 3}, 5}, "1 s", "3 s"), "1 s to 3 s in 5 rounds");
  EXPECT_EQ(shown_ends({{2, 2, 2}, 1}, "2 s", "2 s"), "2 s to 2 s in 1 round");
}

}  // namespace
}  // namespace phytobench
