// SPDX-License-Identifier: MIT
// A graph without loops makes as many instances of a prototype as a grammar with one rule
// A -> A_i B^n per component derives terminals ([Lintermann1997] sec. 3.1): over all ways from the
// root, the sum of the products of the multiplicities.
#include <vector>

#include <gtest/gtest.h>

#include "core/component_graph/instance_tree.hpp"
#include "core/component_graph/test_components.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using namespace test_components;

struct RandomGraph {
  ComponentGraph graph;
  std::vector<std::uint64_t> multiplicity;  // per link
};

/// Links lead from lower to higher numbers only; some twice.
RandomGraph random_acyclic_graph(std::uint64_t seed) {
  CounterStream random(seed, 1);
  const auto below = [&](double n) { return static_cast<std::uint64_t>(n * random.next_unit()); };
  GraphMaker maker;
  RandomGraph result;
  const std::uint64_t size = 2 + below(7.0);
  std::vector<std::uint64_t> count;
  for (std::uint64_t i = 0; i < size; ++i) {
    count.push_back(below(5.0));
    maker.add_counted("c" + std::to_string(i), i % 2 == 0 ? multiplier : bearer,
                      static_cast<double>(count.back()));
  }
  for (std::uint64_t links = 2 * size; links > 0; --links) {
    const std::uint64_t from = below(static_cast<double>(size - 1));
    const std::uint64_t to = from + 1 + below(static_cast<double>(size - 1 - from));
    const bool bears = from % 2 == 1 && below(2.0) == 0;
    maker.link("c" + std::to_string(from), "c" + std::to_string(to),
               bears ? LinkKind::branch : LinkKind::child);
    result.multiplicity.push_back(from % 2 == 0 || bears ? count[from] : 1);
  }
  result.graph = maker.graph();
  return result;
}

/// Applies all rules at once, as often as there are components, and counts the terminals.
std::vector<std::uint64_t> grammar_counts(const RandomGraph& random) {
  const std::size_t size = random.graph.prototypes.size();
  std::vector<std::uint64_t> pending(size, 0), terminals(size, 0);
  pending[random.graph.root] = 1;
  for (std::size_t step = 0; step < size; ++step) {
    std::vector<std::uint64_t> next(size, 0);
    for (std::size_t i = 0; i < size; ++i) terminals[i] += pending[i];
    for (std::size_t i = 0; i < random.graph.links.size(); ++i) {
      const ComponentLink& link = random.graph.links[i];
      next[link.to] += pending[link.from] * random.multiplicity[i];
    }
    pending = next;
  }
  return terminals;
}

TEST(InstanceTreeLaw, AcyclicGraphsCountAsTheGrammarDoes) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const RandomGraph random = random_acyclic_graph(seed);
    const auto expected = grammar_counts(random);
    std::uint64_t all = 0;
    for (const std::uint64_t count : expected) all += count;
    if (all > 20'000) continue;
    const InstanceTree tree = make_instance_tree(random.graph);
    EXPECT_EQ(instances_per_prototype(random.graph, tree), expected) << "seed " << seed;
    ++compared;
  }
  EXPECT_GT(compared, 200u);
}

TEST(InstanceTreeLaw, EveryInstanceStandsRightlyInItsTree) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const RandomGraph random = random_acyclic_graph(seed);
    if (count_instances(random.graph) > 20'000) continue;
    const auto instances = make_instance_tree(random.graph).instances;
    EXPECT_EQ(instances[0].prototype, random.graph.root);
    for (std::size_t i = 1; i < instances.size(); ++i) {
      const Instance& instance = instances[i];
      const ComponentLink& link = random.graph.links[instance.link];
      ASSERT_LT(instance.parent, i);
      EXPECT_EQ(link.to, instance.prototype);
      EXPECT_EQ(link.from, instances[instance.parent].prototype);
      EXPECT_GE(instance.number.i, 1u);
      EXPECT_LE(instance.number.i, instance.number.n);
    }
  }
}

TEST(InstanceTreeLaw, ALoopIsWorthItsUnfolding) {
  // A recursion of depth R is R copies in a row.
  for (std::uint32_t most = 1; most <= 5; ++most) {
    GraphMaker loop, row;
    loop.add_counted("T", bearer, 2.0, most).add("leaf");
    loop.link("T", "T", LinkKind::branch).link("T", "leaf");
    for (std::uint32_t i = 1; i <= most; ++i) row.add_counted("T" + std::to_string(i), bearer, 2.0);
    row.add("leaf");
    for (std::uint32_t i = 1; i <= most; ++i) {
      if (i < most)
        row.link("T" + std::to_string(i), "T" + std::to_string(i + 1), LinkKind::branch);
      row.link("T" + std::to_string(i), "leaf");
    }
    EXPECT_EQ(count_instances(loop.graph()), count_instances(row.graph()));
    EXPECT_EQ(count_instances(loop.graph()), 2u * ((1u << most) - 1u));
  }
}

}  // namespace
}  // namespace phytobench
