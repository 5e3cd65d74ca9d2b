// SPDX-License-Identifier: MIT
// Sec. 3.1: a rule of the graph is a production A ::= A_i B^n. Graphs, unfolded, against the
// L-systems that these productions make, derived until nothing changes.
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "experiments/lintermann1997/published_graphs.hpp"
#include "experiments/lintermann1997/random_graph.hpp"
#include "reference/oracles/lintermann1997_p_graph.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

/// Components whose instances are not as many as their letters.
std::int64_t differing_components(const RandomGraph& random) {
  const ComponentGraph graph = random.as_components();
  const InstanceTree tree = make_instance_tree(graph);
  const LSystem system = random.as_productions();
  const Word word = derived(system, static_cast<int>(random.edges.size()));
  const std::vector<std::uint64_t> letters = symbol_counts(system, word);
  std::int64_t differing = 0;
  for (std::size_t i = 0; i < random.edges.size(); ++i) {
    const auto instances = instances_of(graph, tree, fmt::format("c{}", i));
    const auto symbol = find_symbol(system, std::string(1, RandomGraph::letter('a', i)), 0);
    differing += instances != static_cast<std::int64_t>(letters[*symbol]);
  }
  return differing;
}

/// The letters of a counting grammar as modules of an L-system of the suite, derived in it.
std::map<std::string, std::int64_t> letters_by_engine(const oracles::D0LStructure& grammar,
                                                      int steps) {
  std::map<std::string, std::string> names;
  const auto name = [&](const std::string& letter) {
    return names.try_emplace(letter, fmt::format("N{}.", names.size())).first->second;
  };
  std::string productions, axiom, alphabet;
  for (const std::string& letter : grammar.axiom) axiom += name(letter) + " ";
  for (const auto& [letter, successor] : grammar.successors) {
    productions += name(letter) + " -> ";
    for (const std::string& to : successor) productions += name(to) + " ";
    productions += successor.empty() ? "*\n" : "\n";
  }
  for (const auto& [letter, as] : names) alphabet += as + " ";
  const LSystem system =
      parse_lsystem("alphabet: " + alphabet + "\naxiom: " + axiom + "\n" + productions, "counting");
  const std::vector<std::uint64_t> counts = symbol_counts(system, derived(system, steps));
  std::map<std::string, std::int64_t> letters;
  for (const auto& [letter, as] : names)
    if (const auto symbol = find_symbol(system, as, 0))
      letters[letter] = static_cast<std::int64_t>(counts[*symbol]);
  return letters;
}

/// Recursions need letters that say how deep they are.
void record_recursions(ExperimentContext& context) {
  oracle::PGraph example;
  example["C"].children = 3;
  example["C"].edges = {{"D"}};
  example["D"].maximal_recursions = 3;
  example["D"].edges = {{"D"}};
  context.record("example/D",
                 letters_by_engine(oracle::counting_grammar(example, "C"), 10).at("D_i"));
  oracle::PGraph bush;
  bush["phiball"].children = 3;
  bush["phiball"].maximal_recursions = 5;
  bush["phiball"].edges = {{"tree"}};
  bush["tree"].maximal_recursions = 5;
  bush["tree"].edges = {{"phiball"}};
  const auto counts = letters_by_engine(oracle::counting_grammar(bush, "phiball"), 20);
  context.record("bush/phiball", counts.at("phiball_i"));
  context.record("bush/tree", counts.at("tree_i"));
}

/// D ::= D_i D has no end: as many D_i as there are steps left, times three.
void record_without_limit(ExperimentContext& context) {
  const LSystem system =
      parse_lsystem("axiom: A\nA ::= aB\nB ::= bC\nC ::= cDDD\nD ::= dD\n", "no limit");
  for (const int steps : {6, 12, 24}) {
    const std::vector<std::uint64_t> counts = symbol_counts(system, derived(system, steps));
    context.record(fmt::format("without_limit/steps-{}/D", steps),
                   static_cast<std::int64_t>(counts[*find_symbol(system, "d", 0)]));
  }
}

void run(ExperimentContext& context) {
  const std::int64_t graphs = context.tier() == Tier::smoke ? 100 : 1000;
  std::int64_t differing = 0;
  for (std::int64_t i = 0; i < graphs; ++i) {
    if (i % 100 == 0) context.progress("random graphs");
    differing +=
        differing_components(RandomGraph(context.seed(), static_cast<std::uint64_t>(i))) > 0;
  }
  Record record{.experiment = {},
                .measurement = "graphs_that_differ_from_their_productions",
                .value = differing};
  record.sample_size = graphs;
  record.seed = context.seed();
  context.record(record);
  record_recursions(context);
  record_without_limit(context);
}

}  // namespace

extern const ExperimentDescriptor grammar_of_graph;
constinit const ExperimentDescriptor grammar_of_graph{
    .id = "lintermann1997/grammar-of-graph",
    .question =
        "Does a graph make as many instances as the grammar of its productions has letters?",
    .source = "[Lintermann1997] sec. 3.1",
    .seconds = {0.3, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
