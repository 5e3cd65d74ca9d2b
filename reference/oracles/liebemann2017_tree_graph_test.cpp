// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_tree_graph.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/brzoska2019_l_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"
#include "reference/oracles/turtle_2d.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::oracles::liebemann2017 {
namespace {

TreeGraph graph_of(const D0LSystem& G, int n) {
  return TreeGraph(turtle_2d(modules_of(derive_in_parallel(G, n)), {}).parents);
}

TreeGraph tree_of_equation_2_17(int n) {
  return TreeGraph(turtle_3d(derive(equation_2_17(18.95, 137.5, 1.3), n), {}).parents);
}

TreeGraph brzoska_equation_6(int n) {
  using namespace brzoska2019;
  return TreeGraph(turtle_2d(modules_of(derive(equation_6_corrected(), n)), {1, 10}).parents);
}

std::vector<int> of_tips(const TreeGraph& G, const std::vector<int>& values) {
  std::vector<int> chosen;
  for (const std::size_t tip : tips(G)) chosen.push_back(values[tip]);
  return chosen;
}

int binomial(int n, int k) {
  return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k;
}

TEST(TreeGraphLaw, TurtlesMakeTrees) {
  for (const TreeGraph& G :
       {graph_of(figure_2_5a(), 3), graph_of(figure_2_5b(), 3), tree_of_equation_2_17(4)}) {
    EXPECT_TRUE(is_tree(G.predecessors));
    EXPECT_EQ(G.edges() + 1, G.nodes());
    EXPECT_EQ(depths(G)[0], 0);
    EXPECT_EQ(static_cast<std::size_t>(histogram(degrees(G))[0]), tips(G).size());
  }
  EXPECT_FALSE(is_tree({-1, -1}));
  EXPECT_FALSE(is_tree({-1, 2, 1}));
  EXPECT_FALSE(is_tree({0}));
  EXPECT_FALSE(is_tree({}));
}

TEST(TreeGraphLaw, BranchDepthIsAtMostDepthAndStaysInChains) {
  for (const TreeGraph& G : {graph_of(figure_2_5a(), 3), tree_of_equation_2_17(4)}) {
    const std::vector<int> depth = depths(G);
    for (const std::vector<int>& Z : {branch_depths_at_creation(G), branch_depths_when_finished(G)})
      for (std::size_t v = 1; v < G.nodes(); ++v) {
        EXPECT_LE(Z[v], depth[v]);
        if (G.successors[G.predecessor(v)].size() == 1) EXPECT_EQ(Z[v], Z[G.predecessor(v)]);
      }
  }
}

TEST(TreeGraphLaw, RadiiConserveTheirPowersAtEveryFork) {
  const TreeGraph G = graph_of(figure_2_5a(), 3);
  const std::vector<double> r = radii(G, 0.5, 2.5);
  for (std::size_t v = 0; v < G.nodes(); ++v) {
    double sum = 0;
    for (const int n : G.successors[v]) {
      sum += std::pow(r[static_cast<std::size_t>(n)], 2.5);
      EXPECT_GE(r[v], r[static_cast<std::size_t>(n)] * (1 - 1e-15));
    }
    if (!G.successors[v].empty()) EXPECT_NEAR(std::pow(r[v], 2.5), sum, 1e-12 * sum);
  }
}

TEST(TreeGraph, TheReadingsOfBranchDepthDifferAtAFork) {
  const TreeGraph G({-1, 0, 1, 1, 2});
  EXPECT_EQ(branch_depths_at_creation(G), (std::vector<int>{0, 0, 0, 1, 0}));
  EXPECT_EQ(branch_depths_when_finished(G), (std::vector<int>{0, 0, 1, 1, 1}));
}

TEST(TreeGraph, OfFigure25a) {
  for (int n = 1; n <= 4; ++n) {
    const TreeGraph G = graph_of(figure_2_5a(), n);
    EXPECT_EQ(G.nodes(), (std::size_t{1} << (3 * n)) + 1);
    EXPECT_EQ(tips(G).size(), std::size_t{2} << (3 * (n - 1)));
    EXPECT_EQ(greatest(degrees(G)), 2 * n);
  }
  const TreeGraph G = graph_of(figure_2_5a(), 4);
  EXPECT_EQ(greatest(depths(G)), 61);
  EXPECT_EQ(greatest(branch_depths_at_creation(G)), 29);
  EXPECT_EQ(greatest(branch_depths_when_finished(G)), 29);
  EXPECT_NEAR(radii(G, 1, 2)[0], 32, 1e-12);
  EXPECT_NEAR(radii(G, 1, 2.5)[0], 16, 1e-12);
  EXPECT_NEAR(radii(G, 1, 3)[0], 10.079368, 5e-7);
}

TEST(TreeGraph, OfFigure25b) {
  const TreeGraph G = graph_of(figure_2_5b(), 5);
  EXPECT_EQ(G.nodes(), 3126u);
  EXPECT_EQ(tips(G).size(), 1875u);
  EXPECT_EQ(greatest(degrees(G)), 10);
  EXPECT_EQ(greatest(depths(G)), 63);
  EXPECT_EQ(greatest(branch_depths_at_creation(G)), 62);
  EXPECT_EQ(greatest(branch_depths_when_finished(G)), 62);
  EXPECT_NEAR(radii(G, 1, 2)[0], 43.30127, 5e-6);
  EXPECT_NEAR(radii(G, 1, 2.5)[0], 20.379828, 5e-7);
  EXPECT_NEAR(radii(G, 1, 3)[0], 12.331060, 5e-7);
}

TEST(TreeGraph, OfEquation217) {
  const TreeGraph G = tree_of_equation_2_17(8);
  EXPECT_EQ(G.nodes(), 13121u);
  EXPECT_EQ(histogram(degrees(G)), (Histogram{{0, 6561}, {1, 3280}, {3, 3280}}));
  EXPECT_EQ(degrees(G)[0], 1);
  EXPECT_EQ(histogram(of_tips(G, depths(G))), (Histogram{{16, 6561}}));
  EXPECT_NEAR(radii(G, 1, 2)[0], 81, 1e-11);
  EXPECT_NEAR(radii(G, 1, 2.5)[0], 33.634735, 5e-7);
  EXPECT_NEAR(radii(G, 1, 3)[0], 18.720754, 5e-7);
}

// A tip becomes a node that inherits, and that has three successors: one inherits, two get one
// more.
TEST(TreeGraph, OfEquation217HasItsBranchDepthsInBothReadings) {
  const int n = 8;
  const TreeGraph G = tree_of_equation_2_17(n);
  Histogram tips_with, all_with, finished;
  ++all_with[0];
  for (int step = 0; step <= n; ++step)
    for (int k = 0; k <= step; ++k) {
      const int tips_now = binomial(step, k) * (1 << k);
      if (step == n) tips_with[k] += tips_now;
      if (step > 0) all_with[k] += tips_now;  // they stand
      if (step < n) all_with[k] += tips_now;  // they grow
    }
  for (int k = 0, power = 1; k <= n; ++k, power *= 3) finished[k] = k < n ? 2 * power : power;
  const std::vector<int> Z = branch_depths_at_creation(G);
  EXPECT_EQ(histogram(of_tips(G, Z)), tips_with);
  EXPECT_EQ(histogram(Z), all_with);
  EXPECT_EQ(histogram(branch_depths_when_finished(G)), finished);
  EXPECT_EQ(all_with, (Histogram{{0, 17},
                                 {1, 128},
                                 {2, 560},
                                 {3, 1568},
                                 {4, 2912},
                                 {5, 3584},
                                 {6, 2816},
                                 {7, 1280},
                                 {8, 256}}));
  EXPECT_EQ(
      finished,
      (Histogram{
          {0, 2}, {1, 6}, {2, 18}, {3, 54}, {4, 162}, {5, 486}, {6, 1458}, {7, 4374}, {8, 6561}}));
}

TEST(TreeGraph, OfBrzoskasEquation6) {
  const TreeGraph G = brzoska_equation_6(7);
  EXPECT_EQ(G.nodes(), 73153u);
  EXPECT_EQ(histogram(degrees(G)), (Histogram{{0, 16384}, {1, 40386}, {2, 16383}}));
  EXPECT_EQ(greatest(depths(G)), 635);
  EXPECT_EQ(greatest(branch_depths_at_creation(G)), 21);
  EXPECT_EQ(greatest(branch_depths_when_finished(G)), 21);
  EXPECT_NEAR(radii(G, 1, 2)[0], 128, 1e-9);
  const TreeGraph first = brzoska_equation_6(1);
  EXPECT_EQ(first.nodes(), 10u);
  EXPECT_EQ(tips(first).size(), 4u);
  EXPECT_EQ(greatest(depths(first)), 5);
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
