// SPDX-License-Identifier: MIT
#include "core/component_graph/instance_tree_text.hpp"

#include <gtest/gtest.h>

#include "core/component_graph/instance_measures.hpp"
#include "core/component_graph/test_components.hpp"

namespace phytobench {
namespace {

using namespace test_components;

GraphMaker two_of_two() {
  GraphMaker maker;
  maker.add("A").add_counted("C", multiplier, 2.0).add("D", plain, 2).add("L");
  maker.link("A", "C").link("C", "D").link("D", "D").link("D", "L", LinkKind::leaf);
  return maker;
}

TEST(InstanceTreeText, IsAnIndentedList) {
  const ComponentGraph graph = two_of_two().graph();
  EXPECT_EQ(instance_tree_list(graph, make_instance_tree(graph)),
            "A\n"
            "  C\n"
            "    D 1/2\n"
            "      D #2\n"
            "        L\n"
            "    D 2/2\n"
            "      D #2\n"
            "        L\n");
}

TEST(InstanceTreeText, IsAGraphForGraphviz) {
  GraphMaker maker;
  maker.add_counted("T", bearer, 2.0).add("twig").link("T", "twig", LinkKind::branch);
  const ComponentGraph graph = maker.graph();
  EXPECT_EQ(instance_tree_dot(graph, make_instance_tree(graph)),
            "digraph i_tree {\n"
            "  node [shape=box];\n"
            "  n0 [label=\"T\"];\n"
            "  n1 [label=\"twig 1/2\"];\n"
            "  n0 -> n1 [style=dashed];\n"
            "  n2 [label=\"twig 2/2\"];\n"
            "  n0 -> n2 [style=dashed];\n"
            "}\n");
}

TEST(InstanceMeasures, CountWhatEachLinkMakesAndTheLevels) {
  const ComponentGraph graph = two_of_two().graph();
  const InstanceTree tree = make_instance_tree(graph);
  EXPECT_EQ(instances_per_link(graph, tree), (std::vector<std::uint64_t>{1, 2, 2, 2}));
  EXPECT_EQ(level_count(tree), 5u);
  EXPECT_EQ(level_count({}), 0u);
}

TEST(InstanceMeasures, AllInstancesButTheRootComeFromALink) {
  const ComponentGraph graph = published_example().graph();
  const InstanceTree tree = make_instance_tree(graph);
  std::uint64_t edges = 0;
  for (const std::uint64_t made : instances_per_link(graph, tree)) edges += made;
  EXPECT_EQ(edges, 11u);
  EXPECT_EQ(level_count(tree), 6u);  // A, B, C and three times D
}

}  // namespace
}  // namespace phytobench
