// SPDX-License-Identifier: MIT
// A graph of prototypes of components with the three kinds of links of section 3.3: how many
// instances each gives, and that the tree of instances follows the graph.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/instance_tree.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lintermann1997_instance_counts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// A stem with `twigs` chains of three twigs each; a twig bears `blades` leaves along itself, and
/// the last of a chain ends in a flower.
std::string plant_text(int twigs, int blades) {
  return fmt::format(
      "[graph]\nroot = \"stem\"\n"
      "[component.stem]\nkind = \"simple\"\nshape = \"cylinder\"\n"
      "[component.fork]\nkind = \"hydra\"\ncount = {}\n"
      "[component.twig]\nkind = \"tree\"\nmost_recursions = 3\nbranches = {}\n"
      "[component.blade]\nkind = \"leaf\"\n"
      "[component.flower]\nkind = \"simple\"\n"
      "[[link]]\nfrom = \"stem\"\nto = \"fork\"\n"
      "[[link]]\nfrom = \"fork\"\nto = \"twig\"\n"
      "[[link]]\nfrom = \"twig\"\nto = \"twig\"\n"
      "[[link]]\nfrom = \"twig\"\nto = \"blade\"\nkind = \"branch\"\n"
      "[[link]]\nfrom = \"twig\"\nto = \"flower\"\nkind = \"leaf\"\n",
      twigs, blades);
}

/// The same as productions that only count.
std::vector<oracles::lintermann1997::CountedComponent> counted(std::uint64_t twigs,
                                                               std::uint64_t blades) {
  using namespace oracles::lintermann1997;
  const auto times = [](std::uint64_t child, std::uint64_t branch) {
    return [=](Link link, int, const std::optional<Sibling>&) -> std::optional<std::uint64_t> {
      return link == Link::child ? child : link == Link::branch ? branch : 1;
    };
  };
  std::vector<CountedComponent> graph(5);
  graph[0] = {{}, {{1, Link::child}}, times(1, 0)};
  graph[1] = {{}, {{2, Link::child}}, times(twigs, 0)};
  graph[2] = {3, {{2, Link::child}, {3, Link::branch}, {4, Link::leaf}}, times(1, blades)};
  graph[3] = {{}, {}, times(1, 0)};
  graph[4] = {{}, {}, times(1, 0)};
  return graph;
}

std::int64_t other_than_counted(const std::vector<std::uint64_t>& instances, int twigs,
                                int blades) {
  const auto expected = oracles::lintermann1997::instance_counts(
      counted(static_cast<std::uint64_t>(twigs), static_cast<std::uint64_t>(blades)), 0, 10'000);
  std::int64_t differ = !expected;
  for (std::size_t i = 0; expected && i < instances.size(); ++i)
    differ += (*expected)[i] != instances[i];
  return differ;
}

/// Instances whose parent has no link to them in the graph.
std::int64_t without_a_link(const ComponentGraph& graph, const InstanceTree& tree) {
  std::int64_t count = 0;
  for (std::size_t i = 1; i < tree.instances.size(); ++i) {
    const Instance& instance = tree.instances[i];
    bool linked = false;
    for (const ComponentLink& link : graph.links)
      linked = linked || (link.from == tree.instances[instance.parent].prototype &&
                          link.to == instance.prototype);
    count += !linked || instance.parent >= i;
  }
  return count;
}

void run(ExperimentContext& context) {
  for (const auto& [twigs, blades] : {std::pair{1, 1}, std::pair{4, 5}, std::pair{6, 0}}) {
    const ComponentGraph graph = parse_component_graph(plant_text(twigs, blades), "section 3.3");
    const InstanceTree tree = make_instance_tree(graph);
    const auto instances = instances_per_prototype(graph, tree);
    const std::string name = fmt::format("twigs-{}/blades-{}/", twigs, blades);
    for (std::size_t i = 0; i < instances.size(); ++i)
      context.record(name + graph.prototypes[i].name, static_cast<std::int64_t>(instances[i]),
                     "instances");
    context.record(name + "differs_from_oracle", other_than_counted(instances, twigs, blades));
    context.record(name + "instances_without_a_link", without_a_link(graph, tree), "instances");
    const BuiltPlant plant = build_plant(graph);
    context.record(name + "instances_not_built",
                   static_cast<std::int64_t>(tree.instances.size()) -
                       static_cast<std::int64_t>(plant.instance_count),
                   "instances");
    context.record(name + "triangles", static_cast<std::int64_t>(plant.triangle_count),
                   "triangles");
  }
}

}  // namespace

extern const ExperimentDescriptor p_graph;
constinit const ExperimentDescriptor p_graph{
    .id = "alsweis/p-graph",
    .question = "How many instances do links of the three kinds make of a graph of components?",
    .source = "[Alsweis] section 3.3",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
