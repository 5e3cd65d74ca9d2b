// SPDX-License-Identifier: MIT
// Sec. 2.4.1: the tree that the turtle leaves behind, and the radii that eq. 3.4 gives its
// branches.
#include <map>
#include <span>

#include "core/lsystem/drawing_measures.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/turtle_graphs.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

std::int64_t roots(const Skeleton& skeleton) {
  const auto& parents = skeleton.parents();
  return std::count(parents.begin(), parents.end(), Skeleton::no_parent);
}

/// Nodes from which the predecessors do not lead to the root: on a cycle, or cut off.
std::int64_t astray(const Skeleton& skeleton) {
  std::int64_t astray = 0;
  for (std::size_t node = 0; node < skeleton.node_count(); ++node) {
    std::size_t at = node, edges = 0;
    while (skeleton.parents()[at] >= 0 && edges <= skeleton.node_count()) {
      at = static_cast<std::size_t>(skeleton.parents()[at]);
      ++edges;
    }
    astray += at != 0;
  }
  return astray;
}

/// Lines of the drawing that are not the edge to the node made with them.
std::int64_t lines_without_edge(const Graph& graph) {
  const Drawing drawing = draw(graph.system, graph.word);
  if (drawing.segments.size() != graph.skeleton.edge_count()) return std::int64_t{1} << 40;
  std::int64_t without = 0;
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    const std::int32_t node = static_cast<std::int32_t>(i) + 1;
    const std::int32_t predecessor = graph.skeleton.parents()[i + 1];
    without += drawing.segments[i].to != graph.skeleton.position(node) ||
               drawing.segments[i].from != graph.skeleton.position(predecessor);
  }
  return without;
}

/// Nodes whose predecessor, degree or depth the literal graph has otherwise.
std::int64_t differs_from_oracle(const Graph& graph) {
  const literal::TreeGraph G = literal_graph(graph);
  if (G.nodes() != graph.skeleton.node_count()) return std::int64_t{1} << 40;
  const std::vector<int> degrees = literal::degrees(G), depths = literal::depths(G);
  const std::vector<std::int32_t> found_depths = node_depths(graph.skeleton);
  const ChildLists children(graph.skeleton);
  std::int64_t different = 0;
  for (std::size_t v = 0; v < G.nodes(); ++v)
    different += G.predecessors[v] != graph.skeleton.parents()[v] ||
                 degrees[v] != static_cast<int>(children.of(static_cast<int>(v)).size()) ||
                 depths[v] != found_depths[v];
  return different;
}

void measure(ExperimentContext& context, const std::string& graph_name, const Graph& graph) {
  const Skeleton& skeleton = graph.skeleton;
  const std::string name = graph_name + "/";
  const std::map<std::size_t, std::size_t> degrees = child_counts(skeleton);
  context.record(name + "letters_F", letter_count(graph.system, graph.word, "F"));
  context.record(name + "nodes", static_cast<std::int64_t>(skeleton.node_count()));
  context.record(name + "edges", static_cast<std::int64_t>(skeleton.edge_count()));
  context.record(name + "roots", roots(skeleton));
  context.record(name + "astray", astray(skeleton));
  context.record(name + "lines_without_edge", lines_without_edge(graph));
  context.record(name + "differs_from_oracle", differs_from_oracle(graph));
  context.record(name + "tips", static_cast<std::int64_t>(tip_count(skeleton)));
  context.record(name + "greatest_degree", static_cast<std::int64_t>(degrees.rbegin()->first));
  context.record(name + "depth", static_cast<std::int64_t>(edge_depth(skeleton)));
  context.record(name + "depth_of_root", std::int64_t{node_depths(skeleton)[0]});
  context.record(name + "places", static_cast<std::int64_t>(
                                      distinct_point_count(std::span(skeleton.positions()), 1e-6)));
  if (graph_name != "space-tree") return;
  for (const auto& [degree, nodes] : degrees)
    context.record(fmt::format("{}of_degree-{}", name, degree), static_cast<std::int64_t>(nodes));
  std::int64_t tips_elsewhere = 0;
  const ChildLists children(skeleton);
  const std::vector<std::int32_t> depths = node_depths(skeleton);
  for (std::size_t v = 0; v < depths.size(); ++v)
    tips_elsewhere +=
        children.of(static_cast<std::int32_t>(v)).empty() && depths[v] != 2 * space_tree_steps;
  context.record(name + "tips_of_other_depth", tips_elsewhere);
  context.record(name + "degree_of_root", static_cast<std::int64_t>(children.of(0).size()));
}

/// Words that nobody chose, with branches anywhere.
void measure_random_words(ExperimentContext& context) {
  constexpr int words = 200;
  RandomWords random(context.seed(), 8, "+-&^\\/");
  std::int64_t letters = 0, nodes = 0, wrong = 0, lines = 0, strays = 0, several_roots = 0;
  for (int i = 0; i < words; ++i) {
    const Graph graph = graph_of("&(0)" + random.next(80, true));
    letters += letter_count(graph.system, graph.word, "F");
    nodes += static_cast<std::int64_t>(graph.skeleton.node_count());
    wrong += differs_from_oracle(graph);
    lines += lines_without_edge(graph);
    strays += astray(graph.skeleton);
    several_roots += roots(graph.skeleton) != 1;
  }
  record_seeded(context, "random-words/words", std::int64_t{words});
  record_seeded(context, "random-words/letters_F", letters);
  record_seeded(context, "random-words/nodes", nodes);
  record_seeded(context, "random-words/differs_from_oracle", wrong);
  record_seeded(context, "random-words/lines_without_edge", lines);
  record_seeded(context, "random-words/astray", strays);
  record_seeded(context, "random-words/not_one_root", several_roots);
}

/// Words so short that the rules for F, [ and ] can be read off.
void measure_short_words(ExperimentContext& context) {
  const Graph nothing = graph_of("A"), fork = graph_of("F(2)[+(90)F(1)[F(1)]]F(3)");
  context.record("short-words/nodes_without_F",
                 static_cast<std::int64_t>(nothing.skeleton.node_count()));
  context.record("short-words/root_off_origin", norm(nothing.skeleton.position(0)));
  for (std::size_t v = 1; v < fork.skeleton.node_count(); ++v)
    context.record(fmt::format("short-words/predecessor_of-{}", v),
                   std::int64_t{fork.skeleton.parents()[v]});
}

void run(ExperimentContext& context) {
  for (const auto& [name, graph] : graphs_of_the_figures()) measure(context, name, graph);
  measure_random_words(context);
  measure_short_words(context);
}

}  // namespace

extern const ExperimentDescriptor tree_graphs;
constinit const ExperimentDescriptor tree_graphs{
    .id = "liebemann2017/tree-graphs",
    .question = "Which trees do the turtle's drawings leave behind?",
    .source = "[Liebemann2017] sec. 2.4.1",
    .seconds = {0.5, 0.5, 0.5},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
