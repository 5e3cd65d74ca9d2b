// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_space_colonization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/oracles/liebemann2017_ring_example.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::oracles::liebemann2017 {
namespace {

using Problem = ColonizationProblem;

TEST(LiebemannColonizationLaw, EveryNodeStandsDFromItsPredecessor) {
  const ColonizedTree tree = colonize(without_repetition(ring_example(300, 200, 1, 300)));
  ASSERT_TRUE(is_tree(tree.predecessors));
  for (std::size_t v = 1; v < tree.nodes.size(); ++v) {
    const auto p = static_cast<std::size_t>(tree.predecessors[v]);
    EXPECT_NEAR(norm(minus(tree.nodes[v], tree.nodes[p])), 15, 1e-12);
  }
}

TEST(LiebemannColonizationLaw, PointsAreLeftIfAndOnlyIfNoNodeIsNear) {
  for (const int iterations : {1, 5, 20, 300}) {
    const Problem problem = without_repetition(ring_example(300, 200, 2, iterations));
    const ColonizedTree tree = colonize(problem);
    for (std::size_t s = 0; s < problem.S.size(); ++s) {
      const bool near = std::any_of(tree.nodes.begin(), tree.nodes.end(), [&](const Point& node) {
        return norm(minus(node, problem.S[s])) <= problem.d_k;
      });
      EXPECT_EQ(std::count(tree.left.begin(), tree.left.end(), s), near ? 0 : 1);
    }
  }
}

TEST(LiebemannColonizationLaw, BranchDepthsAreThoseAtCreation) {
  const ColonizedTree tree = colonize(without_repetition(ring_example(300, 200, 3, 300)));
  EXPECT_EQ(tree.Z, branch_depths_at_creation(TreeGraph(tree.predecessors)));
}

// In this cloud six nodes grow again after a pause.
TEST(LiebemannColonizationLaw, NoGrowCountsFromTheLastSuccessor) {
  for (const int max_NG : {2, 7, Problem::unlimited}) {
    Problem problem = without_repetition(ring_example(300, 200, 10, 40));
    problem.max_NG = max_NG;
    const ColonizedTree tree = colonize(problem);
    std::vector<int> last = tree.born;  // own creation, then that of the successors
    for (std::size_t v = 1; v < tree.nodes.size(); ++v)
      last[static_cast<std::size_t>(tree.predecessors[v])] = tree.born[v];
    for (std::size_t v = 0; v < tree.nodes.size(); ++v)
      EXPECT_EQ(tree.no_grow[v], std::min(max_NG, tree.iterations - last[v]));
  }
}

TEST(LiebemannColonization, GivesAPointAtEqualDistancesToTheFirstNode) {
  Problem problem = two_point_trap(0, 0, 2);
  problem.S = {{0, 60, 0}, {50, 7.5, 0}, {-50, 7.5, 0}};
  // After one step up the two points at the side are as far from the root as from its successor.
  EXPECT_EQ(colonize(problem).predecessors, (std::vector<int>{-1, 0, 0, 1}));
}

TEST(LiebemannColonization, GrowsStraightTowardsOnePoint) {
  for (const Boundary boundary : {Boundary::within, Boundary::outside})
    for (const double L : {100.0, 95.0, 80.0, 35.0, 34.0, 21.0}) {
      Problem problem = two_point_trap(0, -L, 100);
      problem.S.resize(1);
      problem.boundary = boundary;
      problem.d_i = 101;
      const ColonizedTree tree = colonize(problem);
      EXPECT_EQ(static_cast<int>(tree.nodes.size()) - 1,
                nodes_towards_one_point(L, 20, 15, boundary));
      EXPECT_EQ(tree.stop, Stop::all_points_removed);
      EXPECT_EQ(tree.distances_of_step_1,
                static_cast<std::uint64_t>(tree.nodes.size() - 1) * tree.nodes.size() / 2);
    }
  EXPECT_EQ(nodes_towards_one_point(100, 20, 15, Boundary::within), 6);
  EXPECT_EQ(nodes_towards_one_point(95, 20, 15, Boundary::within), 5);  // L - k D = d_k
  EXPECT_EQ(nodes_towards_one_point(95, 20, 15, Boundary::outside), 6);
}

TEST(LiebemannColonization, TheBoundaryDecidesWhetherANodeIsInReach) {
  Problem problem = two_point_trap(0, -100, 3);
  EXPECT_GT(colonize(problem).nodes.size(), 1u);
  problem.boundary = Boundary::outside;
  const ColonizedTree tree = colonize(problem);
  EXPECT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.iterations, 0);
  EXPECT_EQ(tree.stop, Stop::no_node_in_reach);
}

TEST(LiebemannColonization, ACircleAroundItsRootCannotGrow) {
  Problem problem = ring_example(0, 500, 1, 400);
  problem.root = {};
  for (int i = 0; i < 2000; ++i)
    problem.S.push_back({500 * std::cos(i * 0.001 * std::numbers::pi),
                         500 * std::sin(i * 0.001 * std::numbers::pi), 0});
  const ColonizedTree tree = colonize(problem);
  EXPECT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.iterations, 0);
  EXPECT_EQ(tree.stop, Stop::no_node_in_reach);
}

TEST(LiebemannTropism, OfAddedToTheSumFadesWithTheNumberOfPoints) {
  for (const int k : {1, 2, 4, 8}) {
    const Point sum{static_cast<double>(k), 0, 0}, T{0, 1, 0};
    const Point printed = equation_3_2(sum, T, Tropism::added_to_the_sum);
    EXPECT_NEAR(std::atan2(printed.y, printed.x), std::atan(1.0 / k), 1e-15);
    const Point unit = equation_3_2(sum, T, Tropism::added_to_the_unit_vector);
    EXPECT_NEAR(std::atan2(unit.y, unit.x), std::numbers::pi / 4, 1e-15);
    EXPECT_NEAR(norm(printed), 1, 1e-15);
  }
  const auto degrees_for = [](int k) { return std::atan(1.0 / k) * 180 / std::numbers::pi; };
  EXPECT_NEAR(degrees_for(2), 26.565, 5e-4);
  EXPECT_NEAR(degrees_for(4), 14.036, 5e-4);
  EXPECT_NEAR(degrees_for(8), 7.125, 5e-4);
}

TEST(LiebemannConditions, HoldForEveryNode) {
  Problem problem = without_repetition(ring_example(500, 250, 4, 400));
  problem.max_grad = 2;
  problem.max_Z = 2;
  const ColonizedTree tree = colonize(problem);
  const TreeGraph graph(tree.predecessors);
  EXPECT_LE(greatest(degrees(graph)), 2);
  EXPECT_LE(greatest(tree.Z), 2);
  const ColonizedTree free = colonize(without_repetition(ring_example(500, 250, 4, 400)));
  EXPECT_GT(greatest(degrees(TreeGraph(free.predecessors))), 2);  // so the limit was at work
}

TEST(LiebemannConditions, WeightedGrowthGoesFromTwoDToD) {
  const double steps[] = {30, 26.25, 22.5, 18.75, 15};
  for (int Z = 0; Z <= 4; ++Z) EXPECT_EQ(weighted_step(15, Z, 4), steps[Z]);
  EXPECT_EQ(weighted_step(15, 0, 1), 30);
  EXPECT_EQ(weighted_step(15, 1, 1), 15);
  EXPECT_TRUE(std::isnan(weighted_step(15, 0, 0)));
  EXPECT_TRUE(std::isnan(weighted_step(15, 0, Problem::unlimited)));
  Problem problem = without_repetition(ring_example(500, 250, 4, 400));
  problem.weighted_growth = true;
  EXPECT_EQ(colonize(problem).stop, Stop::undefined);
  problem.max_Z = 3;
  const ColonizedTree tree = colonize(problem);
  for (std::size_t v = 1; v < tree.nodes.size(); ++v) {
    const auto p = static_cast<std::size_t>(tree.predecessors[v]);
    EXPECT_NEAR(norm(minus(tree.nodes[v], tree.nodes[p])), weighted_step(15, tree.Z[p], 3), 1e-12);
  }
}

TEST(LiebemannConditions, NoGrowSavesDistances) {
  const Problem problem = without_repetition(ring_example(500, 250, 1, 400));
  const ColonizedTree all = colonize(problem);
  double before = 0;
  for (const int max_NG : {1, 2, 3, 5, 10, 20}) {
    Problem limited = problem;
    limited.max_NG = max_NG;
    const ColonizedTree tree = colonize(limited);
    const double share = static_cast<double>(tree.distances_of_step_1) /
                         static_cast<double>(all.distances_of_step_1);
    EXPECT_GT(share, before);
    before = share;
    EXPECT_NE(tree.stop, Stop::most_iterations);
  }
  EXPECT_LT(before, 1.1);
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
