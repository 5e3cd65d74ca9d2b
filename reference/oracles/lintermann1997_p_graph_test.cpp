// SPDX-License-Identifier: MIT
#include "reference/oracles/lintermann1997_p_graph.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench::oracles::lintermann1997 {
namespace {

constexpr std::size_t enough_instances = 100000;

// Sec. 3.1.1: A -> B -> C (three times) -> D, and D to itself, three times at most.
PGraph example_graph() {
  return {{"A", {9, 1, 1, {{"B"}}}},
          {"B", {9, 1, 1, {{"C"}}}},
          {"C", {9, 3, 1, {{"D"}}}},
          {"D", {3, 1, 1, {{"D"}}}}};
}

void expect_same_counts(const PGraph& graph, const std::string& root) {
  const ITree tree = i_tree(graph, root, {}, enough_instances);
  ASSERT_FALSE(tree.cut_off);
  for (const auto& [name, count] : instances_by_grammar(graph, root))
    EXPECT_EQ(count, Natural(static_cast<std::uint64_t>(tree.count(name)))) << name;
}

TEST(PGraph, OfTheExampleHasNineInstancesOfD) {
  const ITree tree = i_tree(example_graph(), "A", {}, enough_instances);
  EXPECT_EQ(tree.count("A"), 1);
  EXPECT_EQ(tree.count("B"), 1);
  EXPECT_EQ(tree.count("C"), 1);
  EXPECT_EQ(tree.count("D"), 9);
  EXPECT_EQ(tree.instances(), 12u);
  EXPECT_EQ(tree.edges(), 11u);
  // D_i1, D_i2, D_i3 below each other, for i = 1, 2, 3 below C.
  EXPECT_EQ(tree.parents, (std::vector<int>{-1, 0, 1, 2, 3, 4, 2, 6, 7, 2, 9, 10}));
}

TEST(PGraph, OnlyOneOfFourReadingsGivesTheExample) {
  const auto D = [](Comparison comparison, Counter counter) {
    return i_tree(example_graph(), "A", {comparison, counter, {}}, enough_instances).count("D");
  };
  EXPECT_EQ(D(Comparison::less, Counter::never_decremented), 2);
  EXPECT_EQ(i_tree(example_graph(), "A", as_printed, enough_instances).count("D"), 2);
  EXPECT_EQ(D(Comparison::less, Counter::decremented), 6);
  EXPECT_EQ(D(Comparison::less_or_equal, Counter::never_decremented), 3);
  EXPECT_EQ(D(Comparison::less_or_equal, Counter::decremented), 9);
}

TEST(PGraph, AsPrintedAndWithOneRecursionBuildsNothing) {
  PGraph graph = example_graph();
  for (const char* name : {"A", "B", "C"}) graph[name].maximal_recursions = 1;
  EXPECT_EQ(i_tree(graph, "A", as_printed, enough_instances).instances(), 0u);
  EXPECT_EQ(i_tree(graph, "A", {}, enough_instances).instances(), 12u);
}

TEST(PGraph, AMultiplierInsideOfTheLoopMultipliesEachTime) {
  PGraph graph = example_graph();
  graph["D"].edges = {{"C"}};  // D -> C -> D instead of D -> D
  const ITree tree = i_tree(graph, "A", {}, enough_instances);
  EXPECT_EQ(tree.count("D"), 3 + 9 + 27);
  expect_same_counts(graph, "A");
}

TEST(PGraph, ALeafComesOnceForEachRecursionThatEnds) {
  PGraph graph = example_graph();
  graph["D"].edges.push_back({"E", Link::leaf});
  graph["E"] = {};
  for (const LeafPlace place : {LeafPlace::at_the_last_instance, LeafPlace::for_each_refusal}) {
    Reading reading;
    reading.leaf_place = place;
    const ITree tree = i_tree(graph, "A", reading, enough_instances);
    EXPECT_EQ(tree.count("E"), 3);
    for (std::size_t i = 0; i < tree.instances(); ++i)
      if (tree.prototypes[i] == "E")
        EXPECT_EQ(tree.prototypes[static_cast<std::size_t>(tree.parents[i])], "D");
  }
  expect_same_counts(graph, "A");
}

TEST(PGraph, LeafReadingsDifferIfTheMultiplierIsInsideOfTheLoop) {
  PGraph graph = example_graph();
  graph["D"].edges = {{"C"}, {"E", Link::leaf}};
  graph["E"] = {};
  const auto leaves = [&](LeafPlace place) {
    Reading reading;
    reading.leaf_place = place;
    return i_tree(graph, "A", reading, enough_instances).count("E");
  };
  EXPECT_EQ(leaves(LeafPlace::at_the_last_instance), 27);
  EXPECT_EQ(leaves(LeafPlace::for_each_refusal), 81);
}

TEST(PGraph, BranchLinksMultiplyAndChildLinksDoNot) {
  const PGraph willow{{"stem", {1, 1, 5, {{"twig", Link::branch}, {"top"}}}},
                      {"twig", {1, 1, 4, {{"leaf", Link::branch}}}},
                      {"top", {}},
                      {"leaf", {}}};
  const ITree tree = i_tree(willow, "stem", {}, enough_instances);
  EXPECT_EQ(tree.count("twig"), 5);
  EXPECT_EQ(tree.count("leaf"), 20);
  EXPECT_EQ(tree.count("top"), 1);
  expect_same_counts(willow, "stem");
}

TEST(PGraph, OfTheBushHasAsManyTreesAsTheLSystemHasGroups) {
  const PGraph graph{{"PhiBall", {5, 3, 1, {{"Tree"}}}}, {"Tree", {5, 1, 1, {{"PhiBall"}}}}};
  const ITree tree = i_tree(graph, "PhiBall", {}, enough_instances);
  EXPECT_EQ(tree.count("Tree"), 363);
  EXPECT_EQ(tree.count("PhiBall"), 121);
  EXPECT_EQ(static_cast<Count>(tree.count("Tree")), bush_groups(5));
  expect_same_counts(graph, "PhiBall");
}

TEST(PGraph, OfTheDandelion) {
  const PGraph umbel{{"Hydra", {1, 18, 1, {{"Horn"}}}}, {"Horn", {}}};
  EXPECT_EQ(i_tree(umbel, "Hydra", {}, enough_instances).count("Horn"), 18);
  EXPECT_EQ(i_tree(umbel, "Hydra", {}, enough_instances).instances(), 19u);
  const PGraph flower{{"stalk", {1, 1, 1, {{"PhiBall"}}}},
                      {"PhiBall", {1, 300, 1, {{"stem"}}}},
                      {"stem", {1, 1, 1, {{"Hydra"}}}},
                      {"Hydra", {1, 18, 1, {{"hair"}}}},
                      {"hair", {}}};
  const ITree tree = i_tree(flower, "stalk", {}, enough_instances);
  EXPECT_EQ(tree.instances(), 6002u);
  EXPECT_EQ(tree.count("hair"), 5400);
  expect_same_counts(flower, "stalk");
}

TEST(PGraphLaw, WithoutLoopsCountsAreProductsAlongWays) {
  unsigned number = 5;
  const auto draw = [&](unsigned below) {
    number = number * 1664525u + 1013904223u;
    return static_cast<int>((number >> 16) % below);
  };
  for (int graph_number = 0; graph_number < 30; ++graph_number) {
    PGraph graph;
    const int size = 2 + draw(4);
    std::vector<int> expected(static_cast<std::size_t>(size), 0);
    expected[0] = 1;
    for (int a = 0; a < size; ++a) {
      Prototype& A = graph[std::string(1, static_cast<char>('a' + a))];
      A.children = 1 + draw(3);
      for (int b = a + 1; b < size; ++b) {
        if (draw(2) == 0) continue;
        A.edges.push_back({std::string(1, static_cast<char>('a' + b))});
        expected[static_cast<std::size_t>(b)] += expected[static_cast<std::size_t>(a)] * A.children;
      }
    }
    const ITree tree = i_tree(graph, "a", {}, enough_instances);
    for (int a = 0; a < size; ++a)
      EXPECT_EQ(tree.count(std::string(1, static_cast<char>('a' + a))),
                expected[static_cast<std::size_t>(a)]);
    expect_same_counts(graph, "a");
  }
}

TEST(PGraph, IsCutOffInsteadOfFillingTheMemory) {
  const PGraph graph{{"a", {1000, 2, 1, {{"a"}}}}};
  const ITree tree = i_tree(graph, "a", {}, 5000);
  EXPECT_TRUE(tree.cut_off);
  EXPECT_EQ(tree.instances(), 5000u);
}

}  // namespace
}  // namespace phytobench::oracles::lintermann1997
