// SPDX-License-Identifier: MIT
#include "reference/component_counts.hpp"

#include <gtest/gtest.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_registry.hpp"
#include "core/component_graph/instance_tree.hpp"
#include "core/component_graph/parameter_expression.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench {
namespace {

using Counts = std::vector<std::optional<std::uint64_t>>;

/// A ball of spheres on a ball, whose numbers are given as in a file.
ComponentGraph balls(const std::string& outer, const std::string& inner) {
  return parse_component_graph(
      "[graph]\nroot = \"a\"\n[component.a]\nkind = \"phiball\"\ncount = " + outer +
          "\n[component.b]\nkind = \"hydra\"\ncount = " + inner +
          "\n[component.c]\nkind = \"simple\"\n[[link]]\nfrom = \"a\"\n"
          "to = \"b\"\n[[link]]\nfrom = \"b\"\nto = \"c\"\n",
      "balls.toml");
}

std::vector<std::uint64_t> made(const ComponentGraph& graph) {
  return instances_per_prototype(graph, make_instance_tree(graph));
}

TEST(ComponentCounts, AreProductsOfNumbers) {
  EXPECT_EQ(predicted_counts(balls("4", "6")).instances, (Counts{1, 4, 24}));
}

TEST(ComponentCounts, FollowRangesAndFunctionsOfTheSibling) {
  EXPECT_EQ(predicted_counts(balls("4", "[10, 40]")).instances, (Counts{1, 4, 100}));
  EXPECT_EQ(predicted_counts(balls("4", "\"i * n\"")).instances, (Counts{1, 4, 40}));
  EXPECT_EQ(predicted_counts(balls("3", "\"depth + t + 4\"")).instances, (Counts{1, 3, 15}));
}

TEST(ComponentCounts, AreAbsentWhereChanceDecides) {
  const ComponentGraph graph = balls("4", "\"floor(random(2, 9))\"");
  const PredictedCounts predicted = predicted_counts(graph);
  EXPECT_EQ(predicted.instances, (Counts{1, 4, std::nullopt}));
  EXPECT_FALSE(predicted.is_too_large);
  EXPECT_EQ(count_disagreement(graph, made(graph), predicted), "");
}

/// Randomness elsewhere in a component, and even in its children's places, decides nothing.
TEST(ComponentCounts, AreThereIfChanceTurnsAndScalesOnly) {
  ComponentGraph graph = balls("4", "6");
  for (Prototype& prototype : graph.prototypes) {
    const auto keys = prototype.kind->keys;
    for (std::size_t key = 0; key < keys.size(); ++key)
      if (keys[key].name != "count")
        if (auto* range = std::get_if<ParameterRange>(&prototype.settings[key]))
          range->function = parse_parameter_function("value * random(0.9, 1.1)", "here");
  }
  EXPECT_EQ(predicted_counts(graph).instances, (Counts{1, 4, 24}));
}

TEST(ComponentCounts, OfAGrammarThatIsTooLargeAreAbsent) {
  const PredictedCounts predicted = predicted_counts(balls("200000", "\"i * 0\""));
  EXPECT_TRUE(predicted.is_too_large);
  EXPECT_EQ(predicted.instances, Counts(3));
}

TEST(ComponentCounts, NameTheFirstComponentThatDiffers) {
  const ComponentGraph graph = balls("4", "6");
  const PredictedCounts predicted = predicted_counts(graph);
  EXPECT_EQ(count_disagreement(graph, made(graph), predicted), "");
  const std::vector<std::uint64_t> wrong{1, 4, 23};
  EXPECT_EQ(count_disagreement(graph, wrong, predicted),
            "component 'c' has 23 instances where its grammar counts 24");
}

TEST(ComponentCounts, OfEveryPresetAreKnownAndMade) {
  for (const GraphPreset& preset : graph_presets()) {
    const ComponentGraph graph = read_component_graph(preset.file);
    const PredictedCounts predicted = predicted_counts(graph);
    EXPECT_EQ(count_disagreement(graph, made(graph), predicted), "") << preset.name;
    for (const auto& count : predicted.instances) EXPECT_TRUE(count) << preset.name;
  }
}

/// Random graphs of kinds that multiply and bear branches, with loops, leaf links and numbers that
/// depend on depth and sibling.
class RandomGraph {
 public:
  explicit RandomGraph(std::uint64_t seed) : random_(seed, 1) {}

  ComponentGraph next() {
    const std::size_t size = 1 + draw(4);
    ComponentGraph graph;
    for (std::size_t i = 0; i < size; ++i) graph.prototypes.push_back(prototype(i));
    for (std::uint32_t from = 0; from < size; ++from)
      for (std::uint32_t to = 0; to < size; ++to)
        if (draw(2) == 0) graph.links.push_back({from, to, link(graph.prototypes[from])});
    return graph;
  }

 private:
  std::uint64_t draw(std::uint64_t below) {
    return static_cast<std::uint64_t>(random_.next_unit() * static_cast<double>(below));
  }

  Prototype prototype(std::size_t number) {
    constexpr const char* kinds[] = {"phiball", "tree", "simple"};
    constexpr const char* functions[] = {"value", "value * (depth - 1)", "i", "n - i", "depth * n"};
    Prototype prototype = make_prototype(std::string(1, static_cast<char>('a' + number)),
                                         component_kind_named(kinds[draw(std::size(kinds))]));
    const auto keys = prototype.kind->keys;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      if (keys[key].name != "count" && keys[key].name != "branches") continue;
      ParameterRange range = ParameterRange::of(static_cast<double>(draw(4)));
      range.function = parse_parameter_function(functions[draw(std::size(functions))], "here");
      prototype.settings[key] = range;
    }
    if (draw(3) > 0) prototype.most_recursions = static_cast<std::uint32_t>(1 + draw(3));
    return prototype;
  }

  LinkKind link(const Prototype& source) {
    if (draw(4) == 0) return LinkKind::leaf;
    return source.kind->carries_branches && draw(2) == 0 ? LinkKind::branch : LinkKind::child;
  }

  CounterStream random_;
};

TEST(ComponentCountsLaw, AreTheInstancesThatAreMade) {
  RandomGraph random(7);
  int compared = 0, with_leaf_links = 0;
  for (int k = 0; k < 3000; ++k) {
    const ComponentGraph graph = random.next();
    std::vector<std::uint64_t> instances;
    try {
      instances = instances_per_prototype(
          graph, make_instance_tree(graph, {.most_instances = 20'000, .most_levels = 200}));
    } catch (const InputError&) {
      continue;  // no graph of a plant
    }
    ++compared;
    bool has_leaf_links = false;
    for (const ComponentLink& link : graph.links)
      has_leaf_links = has_leaf_links || (link.kind == LinkKind::leaf && instances[link.to] > 0);
    if (has_leaf_links) ++with_leaf_links;
    const PredictedCounts predicted = predicted_counts(graph);
    ASSERT_EQ(count_disagreement(graph, instances, predicted), "") << k;
    for (const auto& count : predicted.instances) ASSERT_TRUE(count) << k;
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(with_leaf_links, 20);
}

}  // namespace
}  // namespace phytobench
