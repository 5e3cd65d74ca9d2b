// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_curve_reduction.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::oracles::liebemann2017 {
namespace {

double cosine(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

PlacedTree arc(int edges, double t_deg) {
  PlacedTree tree{{{}}, {-1}};
  for (int i = 0; i < edges; ++i) {
    const Point step{cosine(i * t_deg), cosine(90 - i * t_deg), 0};
    tree.nodes.push_back(plus(tree.nodes.back(), step));
    tree.predecessors.push_back(i);
  }
  return tree;
}

// Root, a bent way to a fork, two bent branches.
PlacedTree fork() {
  return {{{0, 0, 0}, {0, 1, 0}, {0.1, 2, 0}, {-1, 3, 0}, {1, 3, 0}, {-2, 4.1, 0}, {2, 4.2, 0}},
          {-1, 0, 1, 2, 2, 3, 4}};
}

const ReductionOrder orders[] = {ReductionOrder::simultaneous, ReductionOrder::root_to_tip};

TEST(CurveReductionLaw, RootForksAndTipsStay) {
  for (const ReductionOrder order : orders)
    for (const double threshold : {-1.0, 0.0, 0.9, 0.999}) {
      const PlacedTree tree = reduced(fork(), threshold, order);
      ASSERT_TRUE(is_tree(tree.predecessors));
      EXPECT_EQ(tree.nodes[0], fork().nodes[0]);
      EXPECT_EQ(tips(TreeGraph(tree.predecessors)).size(), 2u);
      EXPECT_EQ(histogram(degrees(TreeGraph(tree.predecessors)))[2], 1);
    }
  EXPECT_EQ(reduced(fork(), -1, ReductionOrder::simultaneous).nodes.size(), 4u);
}

TEST(CurveReductionLaw, NothingIsAboveOne) {
  for (const ReductionOrder order : orders)
    EXPECT_EQ(reduced(fork(), 1, order).nodes.size(), fork().nodes.size());
}

TEST(CurveReductionLaw, AStraightChainBecomesOneEdge) {
  for (const ReductionOrder order : orders) {
    const PlacedTree tree = reduced(arc(20, 0), 0.999, order);
    ASSERT_EQ(tree.nodes.size(), 2u);
    EXPECT_EQ(tree.nodes[1], arc(20, 0).nodes[20]);
    EXPECT_EQ(tree.predecessors, (std::vector<int>{-1, 0}));
  }
}

TEST(CurveReduction, OfAnArcDependsOnTheOrder) {
  struct Case {
    double t, T;
    int kept;
  };
  for (const Case& c : {Case{5, 11, 10}, Case{5, 21, 6}, Case{10, 31, 7}, Case{5, 6, 19}}) {
    const PlacedTree tree = arc(36, c.t);
    EXPECT_EQ(kept_nodes(tree, cosine(c.T), ReductionOrder::simultaneous).size(), 2u);
    EXPECT_EQ(kept_nodes(tree, cosine(c.T), ReductionOrder::root_to_tip).size(),
              static_cast<std::size_t>(c.kept));
    EXPECT_EQ(nodes_kept_of_an_arc(36, c.t, c.T, ReductionOrder::simultaneous), 2);
    EXPECT_EQ(nodes_kept_of_an_arc(36, c.t, c.T, ReductionOrder::root_to_tip), c.kept);
  }
  for (const ReductionOrder order : orders) {
    EXPECT_EQ(kept_nodes(arc(36, 5), cosine(4), order).size(), 37u);
    EXPECT_EQ(nodes_kept_of_an_arc(36, 5, 4, order), 37);
  }
}

TEST(CurveReduction, OfAnArcHasItsClosedForm) {
  for (int edges = 1; edges <= 40; edges += 3)
    for (const double t : {1.0, 3.0, 7.0})
      for (const double T : {0.7, 2.2, 3.7, 8.3, 20.6})
        for (const ReductionOrder order : orders)
          EXPECT_EQ(kept_nodes(arc(edges, t), cosine(T), order).size(),
                    static_cast<std::size_t>(nodes_kept_of_an_arc(edges, t, T, order)))
              << edges << " " << t << " " << T;
}

// Where 2 T / t is whole the last chord makes exactly the angle T: rounding decides whether 10 or
// 11 edges become one, and 36 edges give 5 nodes either way.
TEST(CurveReduction, AtAWholeQuotientRoundingDecides) {
  EXPECT_EQ(kept_nodes(arc(36, 2), cosine(11), ReductionOrder::root_to_tip).size(), 5u);
  for (const double T : {10.99, 11.01})
    EXPECT_EQ(nodes_kept_of_an_arc(36, 2, T, ReductionOrder::root_to_tip), 5);
  EXPECT_EQ(nodes_kept_of_an_arc(33, 2, 10.99, ReductionOrder::root_to_tip), 5);
  EXPECT_EQ(nodes_kept_of_an_arc(33, 2, 11.01, ReductionOrder::root_to_tip), 4);
}

TEST(NarrowedBranches, LeaveTheRootAndCloseTheFork) {
  const PlacedTree tree = fork(), closer = narrowed(fork());
  EXPECT_EQ(closer.nodes[0], tree.nodes[0]);
  EXPECT_EQ(closer.predecessors, tree.predecessors);
  const auto cosine_at_fork = [](const PlacedTree& of) {
    const Point a = minus(of.nodes[3], of.nodes[2]), b = minus(of.nodes[4], of.nodes[2]);
    return (a.x * b.x + a.y * b.y) / (norm(a) * norm(b));
  };
  EXPECT_GT(cosine_at_fork(closer), cosine_at_fork(tree));
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
