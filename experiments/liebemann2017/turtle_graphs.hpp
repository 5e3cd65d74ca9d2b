// SPDX-License-Identifier: MIT
// The tree graphs of what [Liebemann2017] ch. 2 draws.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/tree/skeleton.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::liebemann2017 {

/// A word and the tree that the turtle leaves behind.
struct Graph {
  LSystem system;
  Word word;
  Skeleton skeleton;

  Graph(LSystem made_by, Word read)
      : system(std::move(made_by)),
        word(std::move(read)),
        skeleton(turtle_tree(system, word).skeleton) {}
};
inline Graph graph_of(const LSystem& system, int steps) {
  return {system, derived(system, steps)};
}
inline Graph graph_of(const std::string& text) {
  WrittenWord made = written(text, "start: local");
  return {std::move(made.system), std::move(made.word)};
}

inline oracles::liebemann2017::TreeGraph literal_graph(const Graph& graph) {
  const TurtleSettings& turtle = graph.system.turtle;
  return oracles::liebemann2017::TreeGraph(
      oracles::turtle_3d(literal_word(graph.system, graph.word), {turtle.step, turtle.angle_deg})
          .parents);
}

/// Figures 2.4d, 2.5a, 2.5b and 2.6a.
inline std::vector<std::pair<std::string, Graph>> graphs_of_the_figures() {
  std::vector<std::pair<std::string, Graph>> graphs;
  graphs.emplace_back("island", graph_of(koch_system(koch_step(3)), 3));
  graphs.emplace_back("plant-a", graph_of(plant_a_system(), plant_a_steps));
  graphs.emplace_back("plant-b", graph_of(plant_b_system(), plant_b_steps));
  graphs.emplace_back("space-tree", graph_of(space_tree_system(pitch_a_deg), space_tree_steps));
  return graphs;
}

}  // namespace phytobench::experiments::liebemann2017
