// SPDX-License-Identifier: MIT
#include "reference/oracles/lintermann1997_instance_counts.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace phytobench::oracles::lintermann1997 {
namespace {

constexpr std::size_t enough_productions = 100000;

/// The same numbers for every instance.
CountedComponent component(std::vector<CountedEdge> edges, std::uint64_t children = 1,
                           std::optional<int> maximal_recursions = {}, std::uint64_t branches = 1) {
  CountedComponent component;
  component.maximal_recursions = maximal_recursions;
  component.edges = std::move(edges);
  component.times = [=](Link link, int, const std::optional<Sibling>&) {
    return std::optional(link == Link::branch ? branches : children);
  };
  return component;
}

InstanceCounts counts(const std::vector<CountedComponent>& graph) {
  return instance_counts(graph, 0, enough_productions).value();
}

/// Sec. 3.1.1: A -> B -> C (three times) -> D, and D to itself, three times at most.
std::vector<CountedComponent> example_components(int most = 3) {
  return {component({{1}}), component({{2}}), component({{3}}, 3), component({{3}}, 1, most)};
}

TEST(InstanceCounts, OfTheExampleAreNineOfD) {
  EXPECT_EQ(counts(example_components()), (InstanceCounts{1, 1, 1, 9}));
  for (std::uint64_t most = 1; most < 6; ++most)
    EXPECT_EQ(counts(example_components(static_cast<int>(most)))[3], 3 * most);
}

TEST(InstanceCounts, OfAMultiplierInsideOfTheLoopArePowers) {
  auto graph = example_components();
  graph[3] = component({{2}}, 1, 3);
  EXPECT_EQ(counts(graph), (InstanceCounts{1, 1, 1 + 3 + 9 + 27, 3 + 9 + 27}));
}

TEST(InstanceCounts, OfTheBush) {
  EXPECT_EQ(counts({component({{1}}, 3, 5), component({{0}})}), (InstanceCounts{121, 363}));
}

TEST(InstanceCounts, ALeafComesWhereASuccessorIsRefused) {
  auto graph = example_components();
  graph.push_back(component({}));
  graph[3].edges.push_back({4, Link::leaf});
  EXPECT_EQ(counts(graph)[4], 3u);
  // With the multiplier inside of the loop it is the multiplier whose successors are refused, once
  // for each of its 27 last instances.
  graph[3] = component({{2}}, 1, 3);
  graph[2].edges.push_back({4, Link::leaf});
  EXPECT_EQ(counts(graph)[4], 27u);
  // A multiplier that asks for nothing is refused nothing.
  graph[2] = component({{3}, {4, Link::leaf}}, 0);
  EXPECT_EQ(counts(graph), (InstanceCounts{1, 1, 1, 0, 0}));
}

TEST(InstanceCounts, MayDependOnTheDepth) {
  CountedComponent twig = component({{0}, {1, Link::branch}}, 1, 4);
  twig.times = [](Link link, int depth, const std::optional<Sibling>&) {
    return std::optional<std::uint64_t>(link == Link::branch ? 10 * depth : 1);
  };
  EXPECT_EQ(counts({twig, component({})}), (InstanceCounts{4, 10 + 20 + 30 + 40}));
}

TEST(InstanceCounts, MayDependOnTheSibling) {
  CountedComponent part = component({{2}});
  part.times = [](Link, int, const std::optional<Sibling>& sibling) {
    return sibling ? std::optional(sibling->i + 100 * sibling->n) : std::nullopt;
  };
  EXPECT_EQ(counts({component({{1}}, 4), part, component({})}),
            (InstanceCounts{1, 4, 1 + 2 + 3 + 4 + 4 * 400}));
}

TEST(InstanceCounts, AreAbsentBelowWhatChanceDecides) {
  CountedComponent chance = component({{2}});
  chance.times = [](Link, int, const std::optional<Sibling>&) -> std::optional<std::uint64_t> {
    return std::nullopt;
  };
  const InstanceCounts found =
      counts({component({{1}, {4}}, 5), chance, component({{3}}), component({}), component({})});
  EXPECT_EQ(found, (InstanceCounts{1, 5, std::nullopt, std::nullopt, 5}));
}

/// Whether a leaf comes may be a matter of chance, too: nobody knows if something was refused.
TEST(InstanceCounts, AreAbsentBehindALeafLinkOfWhatChanceDecides) {
  CountedComponent chance = component({{0}, {1, Link::leaf}}, 1, 1);
  chance.times = [](Link, int, const std::optional<Sibling>&) -> std::optional<std::uint64_t> {
    return std::nullopt;
  };
  EXPECT_EQ(counts({chance, component({})}), (InstanceCounts{1, std::nullopt}));
}

TEST(InstanceCounts, EndAtTheGreatestNumber) {
  std::vector<CountedComponent> graph{component({{0}, {1}}, 1'000'000, 20), component({})};
  const std::uint64_t greatest = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(counts(graph), (InstanceCounts{greatest, greatest}));
}

TEST(InstanceCounts, OfTooManyProductionsAreNone) {
  CountedComponent part = component({{1}}, 3, 50);
  part.edges.push_back({0});
  std::vector<CountedComponent> graph{part, component({{0}, {1}}, 2, 50)};
  EXPECT_FALSE(instance_counts(graph, 0, 100));
  EXPECT_TRUE(instance_counts(graph, 0, enough_productions));
}

/// Against the instances that the article's algorithm makes, on random graphs with loops.
TEST(InstanceCountsLaw, AreThoseOfTheAlgorithm) {
  unsigned number = 11;
  const auto draw = [&](unsigned below) {
    number = number * 1664525u + 1013904223u;
    return (number >> 16) % below;
  };
  constexpr std::size_t most_instances = 20000;
  int compared = 0;
  for (int graph_number = 0; graph_number < 200; ++graph_number) {
    const std::size_t size = 1 + draw(4);
    PGraph literal;
    std::vector<CountedComponent> graph;
    const auto name = [](std::size_t i) { return std::string(1, static_cast<char>('a' + i)); };
    for (std::size_t a = 0; a < size; ++a) {
      Prototype& A = literal[name(a)];
      A.maximal_recursions = 1 + static_cast<int>(draw(3));
      A.children = static_cast<int>(draw(4));
      A.branches = static_cast<int>(draw(3));
      std::vector<CountedEdge> edges;
      for (std::size_t b = 0; b < size; ++b) {
        if (draw(2) == 0) continue;
        const Link link = draw(2) == 0 ? Link::child : Link::branch;
        A.edges.push_back({name(b), link});
        edges.push_back({b, link});
      }
      graph.push_back(component(edges, static_cast<std::uint64_t>(A.children), A.maximal_recursions,
                                static_cast<std::uint64_t>(A.branches)));
    }
    const ITree tree = i_tree(literal, "a", {}, most_instances);
    if (tree.cut_off) continue;
    ++compared;
    const InstanceCounts found = counts(graph);
    for (std::size_t a = 0; a < size; ++a)
      EXPECT_EQ(found[a], static_cast<std::uint64_t>(tree.count(name(a)))) << graph_number;
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace phytobench::oracles::lintermann1997
