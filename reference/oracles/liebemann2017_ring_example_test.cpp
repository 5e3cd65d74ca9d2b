// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_ring_example.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::oracles::liebemann2017 {
namespace {

TEST(TwoPointTrap, RepeatsOneSuccessorForEver) {
  const ColonizedTree tree = colonize(two_point_trap(40, -50, 500));
  EXPECT_EQ(tree.stop, Stop::most_iterations);
  EXPECT_EQ(tree.iterations, 500);
  EXPECT_EQ(tree.nodes.size(), 501u);
  EXPECT_EQ(distinct_places(tree), 5u);
  EXPECT_EQ(most_identical_successors(tree), 497);
}

TEST(TwoPointTrap, EndsByTheMaximalDegreeOrWithoutRepetition) {
  ColonizationProblem limited = two_point_trap(40, -50, 500);
  limited.max_grad = 3;
  limited.stop_at_standstill = true;
  const ColonizedTree three = colonize(limited);
  EXPECT_EQ(three.stop, Stop::standstill);
  EXPECT_EQ(three.iterations, 7);
  EXPECT_EQ(three.nodes.size(), 7u);
  const ColonizedTree once = colonize(without_repetition(two_point_trap(40, -50, 500)));
  EXPECT_EQ(once.stop, Stop::standstill);
  EXPECT_EQ(once.nodes.size(), 5u);
}

TEST(TwoPointTrap, DividesByZeroBetweenThePoints) {
  ColonizationProblem problem = two_point_trap(40, -45, 500);
  const ColonizedTree printed = colonize(problem);
  EXPECT_EQ(printed.stop, Stop::undefined);
  EXPECT_EQ(printed.nodes.size(), 4u);  // three iterations went well, the fourth did not
  EXPECT_EQ(printed.iterations, 4);
  problem.zero_over_zero = ZeroOverZero::skipped;
  problem.stop_at_standstill = true;
  EXPECT_EQ(colonize(problem).stop, Stop::standstill);
  problem.T = {0, 0.5, 0};
  EXPECT_GT(colonize(problem).nodes.size(), 4u);  // tropism has a direction
}

TEST(TwoPointTrap, IsNoneIfBothPointsAreWithinTheMinimalRadius) {
  const ColonizedTree tree = colonize(two_point_trap(19, -50, 500));
  EXPECT_EQ(tree.stop, Stop::all_points_removed);
  EXPECT_TRUE(tree.left.empty());
}

// Figure 3.2 with its own numbers.
ColonizedTree ring_as_printed(unsigned seed) {
  return colonize(ring_example(2000, 500, seed, 400));
}
ColonizedTree ring_rejecting(unsigned seed) {
  return colonize(without_repetition(ring_example(2000, 500, seed, 400)));
}

TEST(RingExample, DoesNotStopAsPrinted) {
  const ColonizedTree tree = ring_as_printed(17);
  EXPECT_EQ(tree.stop, Stop::most_iterations);
  EXPECT_FALSE(tree.left.empty());
  EXPECT_GT(most_identical_successors(tree), 300);
  EXPECT_GT(tree.nodes.size(), distinct_places(tree) + 300);
}

TEST(RingExample, StopsWithoutRepeatedSuccessors) {
  const ColonizedTree tree = ring_rejecting(17);
  EXPECT_EQ(tree.stop, Stop::standstill);
  EXPECT_EQ(distinct_places(tree), tree.nodes.size());
  EXPECT_NEAR(radii(TreeGraph(tree.predecessors), 1, 2)[0], 15.9, 1.5);
}

// Nearly every cloud of points has a pair that traps a node; one of these twenty has none.
TEST(RingExampleSlow, NearlyNeverStopsAsPrinted) {
  std::vector<unsigned> stopped;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ColonizedTree tree = ring_as_printed(seed);
    if (tree.stop == Stop::all_points_removed) {
      stopped.push_back(seed);
      continue;
    }
    EXPECT_EQ(tree.stop, Stop::most_iterations);
    EXPECT_FALSE(tree.left.empty());
    EXPECT_GT(most_identical_successors(tree), 300);
  }
  EXPECT_EQ(stopped, std::vector<unsigned>{4});
}

TEST(RingExampleSlow, StopsWithoutRepeatedSuccessorsSoon) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ColonizedTree tree = ring_rejecting(seed);
    EXPECT_EQ(tree.stop, seed == 4 ? Stop::all_points_removed : Stop::standstill);
    EXPECT_GE(tree.iterations, 71);
    EXPECT_LE(tree.iterations, 73);
    EXPECT_GE(tree.nodes.size(), 1298u);
    EXPECT_LE(tree.nodes.size(), 1365u);
    EXPECT_LE(tree.left.size(), 18u);
    EXPECT_GE(greatest(tree.Z), 3);
    EXPECT_LE(greatest(tree.Z), 4);
  }
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
