// SPDX-License-Identifier: MIT
#include "core/component_graph/instance_tree.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/component_graph/instance_identity.hpp"
#include "core/component_graph/parameter_expression.hpp"
#include "core/component_graph/test_components.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using namespace test_components;
using Counts = std::map<std::string, std::uint64_t>;

Counts counts_of(const GraphMaker& maker) {
  const ComponentGraph graph = maker.graph();
  const InstanceTree tree = make_instance_tree(graph);
  EXPECT_EQ(count_instances(graph), tree.instances.size());
  Counts counts;
  const auto per_prototype = instances_per_prototype(graph, tree);
  for (std::size_t i = 0; i < per_prototype.size(); ++i)
    counts[graph.prototypes[i].name] = per_prototype[i];
  return counts;
}

std::string refusal(const GraphMaker& maker, const InstanceLimits& limits = {}) {
  try {
    make_instance_tree(maker.graph(), limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(InstanceTree, ThePublishedExampleHasNineBranchParts) {
  const InstanceTree tree = make_instance_tree(published_example().graph());
  EXPECT_EQ(counts_of(published_example()), (Counts{{"A", 1}, {"B", 1}, {"C", 1}, {"D", 9}}));
  ASSERT_EQ(tree.instances.size(), 12u);  // and 11 edges: all but the root have a parent
  // A, B, C, then three times D_i1, D_i2, D_i3, each below the one before.
  for (std::uint32_t i = 1; i <= 3; ++i) {
    for (std::uint32_t depth = 1; depth <= 3; ++depth) {
      const std::uint32_t position = 3 * i + depth - 1;
      const Instance& part = tree.instances[position];
      EXPECT_EQ(part.prototype, 3u);
      EXPECT_EQ(part.depth, depth);
      EXPECT_EQ(part.parent, depth == 1 ? 2u : position - 1);
      EXPECT_EQ(part.number, depth == 1 ? (SiblingNumber{i, 3}) : (SiblingNumber{1, 1}));
    }
  }
}

TEST(InstanceTree, AMultiplierOutsideTheLoopGivesThreeTimesItsLength) {
  for (std::uint32_t most = 1; most <= 6; ++most)
    EXPECT_EQ(counts_of(published_example(most))["D"], 3 * most);
}

TEST(InstanceTree, AMultiplierInsideTheLoopGivesPowers) {
  GraphMaker maker;
  maker.add("A").add("B").add_counted("C", multiplier, 3.0).add("D", plain, 3);
  maker.link("A", "B").link("B", "C").link("C", "D").link("D", "C");
  const Counts counts = counts_of(maker);
  EXPECT_EQ(counts.at("D"), 3u + 9u + 27u);
  EXPECT_EQ(counts.at("C"), 1u + 3u + 9u + 27u);  // the last of them make nothing
}

/// [Lintermann1997] sec. 5.3, as the ledger counts it.
TEST(InstanceTree, TheBushHas363BranchesOn121Balls) {
  GraphMaker maker;
  maker.add_counted("ball", multiplier, 3.0, 5).add("tree");
  maker.link("ball", "tree").link("tree", "ball");
  EXPECT_EQ(counts_of(maker), (Counts{{"ball", 121}, {"tree", 363}}));
}

TEST(InstanceTree, TheDandelion) {
  GraphMaker umbrella;
  umbrella.add_counted("hydra", multiplier, 18.0).add("hair").link("hydra", "hair");
  EXPECT_EQ(counts_of(umbrella), (Counts{{"hydra", 1}, {"hair", 18}}));
  for (const std::uint64_t n : {1u, 7u, 300u}) {
    GraphMaker maker;
    maker.add("stem").add_counted("ball", multiplier, static_cast<double>(n)).add("stalk");
    maker.add_counted("hydra", multiplier, 18.0).add("hair");
    maker.link("stem", "ball").link("ball", "stalk").link("stalk", "hydra").link("hydra", "hair");
    EXPECT_EQ(make_instance_tree(maker.graph()).instances.size(), 2 + 20 * n);
    EXPECT_EQ(counts_of(maker)["hair"], 18 * n);
  }
}

TEST(InstanceTree, ALeafLinkIsUsedOnceWhereARecursionHasEnded) {
  GraphMaker maker = published_example();
  maker.add("L").link("D", "L", LinkKind::leaf);
  EXPECT_EQ(counts_of(maker)["L"], 3u);
  const InstanceTree tree = make_instance_tree(maker.graph());
  for (const Instance& instance : tree.instances) {
    if (instance.prototype != 4) continue;
    EXPECT_EQ(tree.instances[instance.parent].depth, 3u);
    EXPECT_EQ(instance.number, (SiblingNumber{1, 1}));
  }
}

TEST(InstanceTree, ALeafLinkOfAMultiplierIsUsedOnceAsWell) {
  GraphMaker maker;
  maker.add_counted("C", multiplier, 4.0, 2).add("L");
  maker.link("C", "C").link("C", "L", LinkKind::leaf);
  EXPECT_EQ(counts_of(maker), (Counts{{"C", 5}, {"L", 4}}));
}

TEST(InstanceTree, BranchesAreMultipliedAndChildrenOfABearerAreNot) {
  GraphMaker maker;
  maker.add_counted("T", bearer, 5.0).add("twig").add("tip");
  maker.link("T", "twig", LinkKind::branch).link("T", "tip");
  EXPECT_EQ(counts_of(maker), (Counts{{"T", 1}, {"twig", 5}, {"tip", 1}}));
}

TEST(InstanceTree, NothingBelowAMultiplierByZero) {
  GraphMaker maker;
  maker.add_counted("C", multiplier, 0.0).add("D").link("C", "D");
  EXPECT_EQ(counts_of(maker), (Counts{{"C", 1}, {"D", 0}}));
}

/// What the correction of the counter does not say: the inner loop does not start anew. Ways are
/// o i^a o i^b ... with at most three i, and at least one before each further o: for m of the o
/// there are C(4, m), so 4 + 6 + 4 + 1. Anew in each turn they would be 4 (1 + 3 + 9 + 27).
TEST(InstanceTree, ANestedRecursionSharesItsLimitAlongTheWay) {
  GraphMaker maker;
  maker.add("outer", plain, 4).add("inner", plain, 3);
  maker.link("outer", "inner").link("inner", "inner").link("inner", "outer");
  const InstanceTree tree = make_instance_tree(maker.graph());
  EXPECT_EQ(tree.instances.size(), 15u);
  for (const Instance& instance : tree.instances)
    EXPECT_LE(instance.depth, instance.prototype == 0 ? 4u : 3u);
}

TEST(InstanceTree, NumbersThatDifferBetweenSiblingsAreCountedOneByOne) {
  GraphMaker maker;
  maker.add_counted("all", multiplier, 4.0).add_counted("some", multiplier, 1.0).add("part");
  maker.link("all", "some").link("some", "part");
  ComponentGraph graph = maker.graph();
  auto& count = std::get<ParameterRange>(graph.prototypes[1].settings[0]);
  count.frames[0].value = {1.0, 7.0};  // 1, 3, 5, 7
  EXPECT_EQ(count_instances(graph), 1u + 4u + 16u);
  EXPECT_EQ(make_instance_tree(graph).instances.size(), 21u);
  count.function = parse_parameter_function("10 * random(0, 1)", "some.count");
  EXPECT_EQ(make_instance_tree(graph).instances.size(), count_instances(graph));
}

TEST(InstanceTree, IdentitiesDifferAndDoNotDependOnWhatStandsBeside) {
  GraphMaker one, two;
  for (GraphMaker* maker : {&one, &two}) {
    maker->add("root").add_counted("C", multiplier, 1000.0).add("D").add("E");
    maker->link("root", "C").link("C", "D");
  }
  two.link("root", "E");
  std::map<std::uint64_t, int> seen;
  const InstanceTree tree = make_instance_tree(one.graph());
  for (const Instance& instance : tree.instances) ++seen[instance.identity];
  EXPECT_EQ(seen.size(), tree.instances.size());
  EXPECT_EQ(make_instance_tree(two.graph()).instances[500].identity, tree.instances[500].identity);
}

TEST(InstanceTree, RefusesRecursionsThatNeverEnd) {
  GraphMaker loop;
  loop.add("stem").add("twig").link("stem", "twig").link("twig", "twig");
  EXPECT_EQ(refusal(loop),
            "the recursion twig -> twig never ends; give most_recursions to one of its components");
  GraphMaker ring;
  ring.add("a", plain, 3).add("b").add("c");
  ring.link("a", "b").link("b", "c").link("c", "a");
  EXPECT_EQ(refusal(ring), "accepted");
  ring.link("c", "b");
  EXPECT_NE(refusal(ring).find("b -> c -> b never ends"), std::string::npos) << refusal(ring);
}

TEST(InstanceTree, RefusesMoreInstancesThanAllowedBeforeItMakesThem) {
  EXPECT_EQ(refusal(published_example(), {.most_instances = 12}), "accepted");
  EXPECT_EQ(refusal(published_example(), {.most_instances = 11}),
            "the plant would have more than 11 instances of components; lower most_recursions, or "
            "the numbers of children and branches");
  // 3^1000 instances, and 2^40 children of one.
  GraphMaker powers;
  powers.add_counted("C", multiplier, 3.0, 1000).link("C", "C");
  EXPECT_NE(refusal(powers).find("more than 10000000 instances"), std::string::npos);
  GraphMaker many;
  many.add_counted("C", multiplier, 0x1p40).add("D").link("C", "D");
  EXPECT_NE(refusal(many).find("more than 10000000 instances"), std::string::npos);
}

TEST(InstanceTree, RefusesMoreLevelsThanAllowed) {
  GraphMaker longest;
  longest.add("a", plain, 1000).add("b").link("a", "b").link("b", "a");
  EXPECT_EQ(count_instances(longest.graph()), 2000u);
  EXPECT_EQ(make_instance_tree(longest.graph()).instances.back().depth, 1000u);
  EXPECT_EQ(refusal(published_example(), {.most_levels = 6}), "accepted");
  EXPECT_NE(refusal(published_example(), {.most_levels = 5}).find("more than 5 levels"),
            std::string::npos);
}

TEST(InstanceTree, AFunctionThatLeavesTheRangeNamesTheParameter) {
  GraphMaker maker;
  maker.add_counted("C", multiplier, 3.0).add("D").link("C", "D");
  ComponentGraph graph = maker.graph();
  auto& count = std::get<ParameterRange>(graph.prototypes[0].settings[0]);
  count.where = "plant.toml:4: C.count";
  count.function = parse_parameter_function("value - 5", "C.count");
  try {
    make_instance_tree(graph);
    FAIL() << "a negative number of children";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("plant.toml:4: C.count = -2 is not allowed"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace phytobench
