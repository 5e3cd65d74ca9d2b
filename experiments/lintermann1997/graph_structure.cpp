// SPDX-License-Identifier: MIT
// Sec. 3.1: what is a tree, what is a parameter, and which recursions may lie within each other.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_registry.hpp"
#include "core/component_graph/instance_tree_text.hpp"
#include "core/contract/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/published_graphs.hpp"
#include "reference/graph_presets.hpp"
#include "reference/oracles/lintermann1997_p_graph.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

/// Instances that are no node of a tree whose edges come from links of the graph.
std::int64_t misplaced_instances(const ComponentGraph& graph, const InstanceTree& tree) {
  std::int64_t misplaced = 0;
  for (std::size_t i = 1; i < tree.instances.size(); ++i) {
    const Instance& instance = tree.instances[i];
    if (instance.parent >= i) {
      ++misplaced;
      continue;
    }
    const ComponentLink& link = graph.links.at(instance.link);
    misplaced +=
        link.to != instance.prototype || link.from != tree.instances[instance.parent].prototype;
  }
  return misplaced;
}

void record_trees(ExperimentContext& context) {
  for (const char* name : {"bush", "dandelion"}) {
    const ComponentGraph graph = read_component_graph(graph_preset_file(name));
    const InstanceTree tree = make_instance_tree(graph);
    context.record(fmt::format("{}/prototypes", name),
                   static_cast<std::int64_t>(graph.prototypes.size()));
    context.record(fmt::format("{}/instances", name),
                   static_cast<std::int64_t>(tree.instances.size()));
    context.record(fmt::format("{}/misplaced_instances", name), misplaced_instances(graph, tree));
  }
}

/// Links are pairs of letters; every component has the same limit.
ComponentGraph linked(const std::vector<std::string>& links, int limit) {
  std::string text = "[graph]\nroot = \"a\"\n", letters;
  for (const std::string& link : links)
    for (const char letter : link)
      if (letters.find(letter) == std::string::npos) letters += letter;
  for (const char letter : letters)
    text += fmt::format("[component.{}]\nkind = \"horn\"\nmost_recursions = {}\n", letter, limit);
  for (const std::string& link : links)
    text += fmt::format("[[link]]\nfrom = \"{}\"\nto = \"{}\"\n", link[0], link[1]);
  return parse_component_graph(text, "recursions");
}

std::int64_t by_the_algorithm(const std::vector<std::string>& links, int limit) {
  oracle::PGraph graph;
  for (const std::string& link : links) {
    graph[link.substr(0, 1)].edges.push_back({link.substr(1, 1)});
    for (const char letter : link) graph[std::string(1, letter)].maximal_recursions = limit;
  }
  return static_cast<std::int64_t>(oracle::i_tree(graph, "a", {}, 100000).instances());
}

bool is_refused(const std::vector<std::string>& links) {
  try {
    static_cast<void>(count_instances(linked(links, 3)));
  } catch (const InputError&) {
    return true;
  }
  return false;
}

void record_recursions(ExperimentContext& context) {
  const std::vector<std::string> nested{"ab", "bb", "ba"}, overlapping{"ab", "ba", "bc", "cb"};
  context.record("nested/instances", static_cast<std::int64_t>(count_instances(linked(nested, 3))));
  context.record("nested/instances_by_the_algorithm", by_the_algorithm(nested, 3));
  context.record("nested/refused", std::int64_t{is_refused(nested)});
  context.record("overlapping/refused", std::int64_t{is_refused(overlapping)});
  context.record("overlapping/instances_by_the_algorithm", by_the_algorithm(overlapping, 3));

  std::int64_t kinds = 0, without_limit = 0;
  for (const ComponentKind* kind : all_component_kinds()) {
    if (!kind->built()) continue;
    ++kinds;
    const std::string text = fmt::format(
        "[graph]\nroot = \"a\"\n[component.a]\nkind = \"{}\"\nmost_recursions = 2\n"
        "[[link]]\nfrom = \"a\"\nto = \"a\"\n",
        kind->name);
    std::uint32_t deepest = 0;
    for (const Instance& instance :
         make_instance_tree(parse_component_graph(text, "kind")).instances)
      deepest = std::max(deepest, instance.depth);
    without_limit += deepest != 2;
  }
  context.record("kinds_without_their_limit", without_limit);
  context.record("kinds_at_least", kinds);
}

/// What changes in the i-tree with a parameter of geometry, and with the n of a multiplier.
void record_separation(ExperimentContext& context) {
  const auto list = [](std::string_view of_C) {
    const ComponentGraph graph = published_example(3, loop_of_D, of_C);
    return instance_tree_list(graph, make_instance_tree(graph));
  };
  context.record("tilt_changed/same_tree", std::int64_t{list("tilt = 20.0") == list("")});
  const auto four = [](const std::string& text) {
    const ComponentGraph graph = parse_component_graph(text, "sec. 3.1.1 with n = 4");
    return instances_of(graph, make_instance_tree(graph), "D");
  };
  context.record("n_changed_to_4/D",
                 four("[graph]\nroot = \"C\"\n[component.C]\nkind = \"hydra\"\ncount = 4\n"
                      "[component.D]\nkind = \"horn\"\nmost_recursions = 3\n"
                      "[[link]]\nfrom = \"C\"\nto = \"D\"\n[[link]]\nfrom = \"D\"\nto = \"D\"\n"));
}

void run(ExperimentContext& context) {
  record_trees(context);
  record_recursions(context);
  record_separation(context);
}

}  // namespace

extern const ExperimentDescriptor graph_structure;
constinit const ExperimentDescriptor graph_structure{
    .id = "lintermann1997/graph-structure",
    .question = "Is the i-tree a tree, and which recursions may the p-graph have?",
    .source = "[Lintermann1997] sec. 3.1",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
