// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_oppenheimer.hpp"

#include <gtest/gtest.h>

namespace phytobench::oracles::brzoska2019 {
namespace {

TEST(RecursiveTree, OfEqualDepthHasItsPowers) {
  EXPECT_EQ(segments_of_equal_depth(2, 3), 40);
  EXPECT_EQ(leaves_of_equal_depth(2, 3), 27);
  EXPECT_EQ(segments_of_equal_depth(2, 5), 364);
  EXPECT_EQ(leaves_of_equal_depth(2, 5), 243);
  EXPECT_EQ(segments_of_equal_depth(3, 5), 1365);
  EXPECT_EQ(leaves_of_equal_depth(3, 5), 1024);
}

TEST(RecursiveTree, OfEqualRatiosIsOfEqualDepth) {
  for (int n = 1; n <= 3; ++n)
    for (int k = 0; k <= 5; ++k) {
      // 2^-k is the first size below 1.5 * 2^-k.
      const RecursiveTree tree = listing_1({1, 0.5, 0.5, n, 1.5 * std::pow(0.5, k)});
      EXPECT_EQ(tree.segments, segments_of_equal_depth(n, k));
      EXPECT_EQ(tree.leaves, leaves_of_equal_depth(n, k));
    }
}

TEST(RecursiveTree, WithASizeTestCountsWaysOnALattice) {
  struct Case {
    RecursiveTreeProblem problem;
    std::int64_t segments, leaves;
    double total_size, tolerance;
  };
  for (const Case& c : {Case{{1, 0.8, 0.5, 1, 0.1}, 175, 88, 22.79958, 5e-6},
                        Case{{1, 0.9, 0.6, 2, 0.2}, 1141, 761, 222.858463, 5e-7},
                        Case{{1, 0.75, 0.5, 3, 0.1}, 1117, 838, 101.787373, 5e-7}}) {
    for (const RecursiveTree& tree : {listing_1(c.problem), closed_form_of_listing_1(c.problem)}) {
      EXPECT_EQ(tree.segments, c.segments);
      EXPECT_EQ(tree.leaves, c.leaves);
      EXPECT_NEAR(tree.total_size, c.total_size, c.tolerance);
    }
    EXPECT_EQ(leaves_of_segments(c.segments, c.problem.branches), c.leaves);
  }
}

TEST(RecursiveTreeLaw, LeavesFollowFromSegments) {
  for (int n = 1; n <= 4; ++n)
    for (const double least : {0.9, 0.5, 0.31, 0.22}) {
      const RecursiveTree tree = listing_1({1, 0.7, 0.45, n, least});
      EXPECT_EQ(tree.leaves, leaves_of_segments(tree.segments, n));
      EXPECT_EQ(tree.segments, closed_form_of_listing_1({1, 0.7, 0.45, n, least}).segments);
    }
}

}  // namespace
}  // namespace phytobench::oracles::brzoska2019
