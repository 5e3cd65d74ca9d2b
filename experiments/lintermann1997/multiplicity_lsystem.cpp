// SPDX-License-Identifier: MIT
// Sec. 3.1 says that no grammar can have the n of A ::= A_i B^n as a parameter that the component
// keeps and sets. Two parametric L-systems that do, beside graphs that do the same.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/instance_tree.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int largest_n = 20;

/// c is the instance of C; R(k) has k instances d still to make.
constexpr const char* multiplier =
    "axiom: C({})\n"
    "C(n) -> cR(n)\n"
    "R(k) : k > 0 -> dR(k - 1)\n"
    "R(k) : k <= 0 -> *\n";

/// C(n) makes n components C(n - 1): each sets the n of what it makes.
constexpr const char* falling_multiplier =
    "axiom: C({})\n"
    "C(n) -> cR(n, n)\n"
    "R(k, n) : k > 0 -> C(n - 1)R(k - 1, n)\n"
    "R(k, n) : k <= 0 -> *\n";

std::int64_t letters(const std::string& text, int n, int steps, char letter) {
  const LSystem system = parse_lsystem(fmt::format(fmt::runtime(text), n), "multiplier");
  const std::string word = text_of(system, derived(system, steps));
  return std::count(word.begin(), word.end(), letter);
}

std::int64_t instances_of_D(int n) {
  const ComponentGraph graph =
      parse_component_graph(fmt::format("[graph]\nroot = \"C\"\n"
                                        "[component.C]\nkind = \"hydra\"\ncount = {}\n"
                                        "[component.D]\nkind = \"horn\"\n"
                                        "[[link]]\nfrom = \"C\"\nto = \"D\"\n",
                                        n),
                            "multiplier");
  return static_cast<std::int64_t>(count_instances(graph)) - 1;
}

/// The depth-th C on a way has n - depth + 1 successors.
std::int64_t instances_of_falling_C(int n) {
  const ComponentGraph graph =
      parse_component_graph(fmt::format("[graph]\nroot = \"C\"\n"
                                        "[component.C]\nkind = \"hydra\"\nmost_recursions = {}\n"
                                        "count = \"{} - depth\"\n"
                                        "[[link]]\nfrom = \"C\"\nto = \"C\"\n",
                                        n + 1, n + 1),
                            "falling multiplier");
  return static_cast<std::int64_t>(count_instances(graph));
}

void run(ExperimentContext& context) {
  std::int64_t differing = 0;
  for (int n = 0; n <= largest_n; ++n) {
    const std::int64_t by_lsystem = letters(multiplier, n, n + 2, 'd');
    differing += by_lsystem != instances_of_D(n);
    if (n == 0 || n == 3 || n == 18 || n == largest_n)
      context.record(fmt::format("n-{}/successors", n), by_lsystem);
  }
  context.record("differs_from_graph", differing);

  constexpr int enough_steps = 40;
  std::int64_t falling_differing = 0;
  for (int n = 1; n <= 5; ++n) {
    const std::int64_t by_lsystem = letters(falling_multiplier, n, enough_steps, 'c');
    falling_differing += by_lsystem != instances_of_falling_C(n);
    context.record(fmt::format("falling/n-{}/instances", n), by_lsystem);
  }
  context.record("falling/differs_from_graph", falling_differing);
}

}  // namespace

extern const ExperimentDescriptor multiplicity_lsystem;
constinit const ExperimentDescriptor multiplicity_lsystem{
    .id = "lintermann1997/multiplicity-lsystem",
    .question = "Can a grammar have the number of successors as a parameter?",
    .source = "[Lintermann1997] sec. 3.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
