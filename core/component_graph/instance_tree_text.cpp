// SPDX-License-Identifier: MIT
#include "core/component_graph/instance_tree_text.hpp"

#include <fmt/format.h>

#include "core/component_graph/instance_identity.hpp"

namespace phytobench {

namespace {

std::string label_of(const ComponentGraph& graph, const Instance& instance) {
  std::string label = graph.prototypes[instance.prototype].name;
  if (instance.number.n > 1) label += fmt::format(" {}/{}", instance.number.i, instance.number.n);
  if (instance.depth > 1) label += fmt::format(" #{}", instance.depth);
  return label;
}

std::string_view style_of(LinkKind kind) {
  if (kind == LinkKind::child) return "";
  return kind == LinkKind::branch ? " [style=dashed]" : " [style=dotted]";
}

}  // namespace

std::string instance_tree_list(const ComponentGraph& graph, const InstanceTree& tree) {
  std::string text;
  std::vector<std::size_t> levels;
  for (const Instance& instance : tree.instances) {
    levels.push_back(instance.link == any_link ? 0 : levels[instance.parent] + 1);
    text.append(2 * levels.back(), ' ');
    text += label_of(graph, instance) + "\n";
  }
  return text;
}

std::string instance_tree_dot(const ComponentGraph& graph, const InstanceTree& tree) {
  std::string text = "digraph i_tree {\n  node [shape=box];\n";
  for (std::size_t i = 0; i < tree.instances.size(); ++i) {
    const Instance& instance = tree.instances[i];
    // Names of components hold nothing that would have to be quoted again.
    text += fmt::format("  n{} [label=\"{}\"];\n", i, label_of(graph, instance));
    if (instance.link == any_link) continue;
    text += fmt::format("  n{} -> n{}{};\n", instance.parent, i,
                        style_of(graph.links[instance.link].kind));
  }
  return text + "}\n";
}

}  // namespace phytobench
