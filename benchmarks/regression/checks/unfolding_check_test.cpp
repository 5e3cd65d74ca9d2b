// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/unfolding_check.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "core/component_graph/component_graph_file.hpp"

namespace phytobench {
namespace {

TEST(UnfoldingCheck, AcceptsTheRightTreeAlone) {
  const ComponentGraph graph = parse_component_graph(unfolding_text(), "graph");
  const InstanceTree right = make_instance_tree(graph);
  EXPECT_EQ(right.instances.size(), 19'682u);  // 1 + 9841 + 9840
  EXPECT_EQ(objection_to_unfolding(graph, right), "");
  EXPECT_NE(objection_to_unfolding(graph, {}), "");
  InstanceTree wrong = right;
  wrong.instances[5000].parent = wrong.instances[5000].parent - 1;
  EXPECT_NE(objection_to_unfolding(graph, wrong), "");
  wrong = right;
  wrong.instances[5000].prototype = wrong.instances[5000].prototype == 1 ? 2 : 1;
  EXPECT_NE(objection_to_unfolding(graph, wrong), "");
  wrong = right;
  wrong.instances.pop_back();
  EXPECT_NE(objection_to_unfolding(graph, wrong), "");
}

}  // namespace
}  // namespace phytobench
