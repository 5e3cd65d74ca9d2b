// SPDX-License-Identifier: MIT
// Sec. 2.1, 2.2, 4.2.1: which symbols the systems of ch. 2 are made of, and what names are worth.
#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/word_systems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

bool has_production(const LSystem& system, SymbolIndex symbol) {
  for (const Production& production : system.productions)
    if (production.predecessor.symbol == symbol) return true;
  return false;
}

/// How many symbols, productions and modules of the axiom each system has.
void measure_sets(ExperimentContext& context) {
  const std::pair<std::string, LSystem> systems[] = {
      {"eq-2.1", anabaena_system()},  {"eq-2.2", parametric_system()},
      {"eq-2.6", koch_system(1.0)},   {"fig-2.5a", plant_a_system()},
      {"fig-2.5b", plant_b_system()}, {"eq-2.17", space_tree_system(pitch_a_deg)}};
  std::int64_t one_variable = 0;
  for (const auto& [name, system] : systems) {
    context.record("sets/" + name + "/symbols", whole(system.symbols.size()), "symbols");
    context.record("sets/" + name + "/productions", whole(system.productions.size()),
                   "productions");
    context.record("sets/" + name + "/axiom_modules", whole(system.axiom.size()), "modules");
    one_variable += system.axiom.size() == 1 && has_production(system, system.axiom[0].symbol);
  }
  context.record("sets/axiom_is_one_variable", one_variable, "systems");
}

/// The cells of eq. 2.1 after even and after odd numbers of derivations.
void measure_alternation(ExperimentContext& context) {
  constexpr int last = 20;
  const LSystem system = anabaena_system();
  std::int64_t other = 0, cells = 0;
  for (int n = 0; n <= last; ++n) {
    Word word = derived(system, n);
    for (const SymbolIndex symbol : word.symbols) {
      const std::string& cell = system.symbols[symbol].letter;
      other += n % 2 == 0 ? cell != "ar" && cell != "bl" : cell != "al" && cell != "br";
      ++cells;
    }
  }
  context.record("alternation/cells", cells, "cells");
  context.record("alternation/cells_of_the_other_kind", other, "cells");
}

/// Eq. 2.6 from its axiom of seven letters, and from the one variable in it.
void measure_start(ExperimentContext& context) {
  const LSystem island = koch_system(1.0);
  const LSystem line =
      parse_lsystem("axiom: F\nF -> F+F-F-FF+F+F-F\nangle: 90\n", "one line of the island");
  for (int n = 0; n <= 3; ++n) {
    const std::string name = fmt::format("start/n-{}/", n);
    context.record(name + "lines_from_a_word", letter_count(island, derived(island, n), "F"),
                   "lines");
    context.record(name + "lines_from_a_symbol", letter_count(line, derived(line, n), "F"),
                   "lines");
  }
}

/// Parameters are only names: those of eq. 2.2 exchanged, longer, or called like letters.
void measure_parameter_names(ExperimentContext& context) {
  constexpr int steps = 6;
  const std::vector<std::vector<std::string>> namings = {
      {"y", "x", "y"}, {"long_name", "l", "long_name"}, {"A", "B", "C"}, {"B", "A", "A"}};
  const std::string expected = word_after(parametric_system(), steps);
  std::int64_t differ = 0;
  for (const auto& n : namings) {
    const LSystem renamed =
        parse_lsystem(fmt::format("axiom: A(1, 1)\nA({0}, {1}) -> A({0} + 1, {1} * 2) B({1})\n"
                                  "B({2}) -> B({2} + 1) C\n",
                                  n[0], n[1], n[2]),
                      "renamed");
    differ += word_after(renamed, steps) != expected;
  }
  context.record("names/namings", whole(namings.size()), "systems");
  context.record("names/differ", differ, "systems");
  context.record("names/twice_in_one_predecessor_refused",
                 std::int64_t{is_refused("axiom: A(1, 1)\nA(x, x) -> A(x, x)\n")});
  context.record("names/number_as_parameter_refused",
                 std::int64_t{is_refused("axiom: A(7)\nA(7) -> B\n")});
  const LSystem stretched =
      parse_lsystem("axiom: F F(1) F(1, 2)\nF(l) -> F(l * 1.5)\n", "predecessor and list");
  context.record("names/predecessor_with_its_list", word_after(stretched, 1));
}

void run(ExperimentContext& context) {
  measure_sets(context);
  measure_alternation(context);
  measure_start(context);
  measure_parameter_names(context);
}

}  // namespace

extern const ExperimentDescriptor symbol_sets;
constinit const ExperimentDescriptor symbol_sets{
    .id = "liebemann2017/symbol-sets",
    .question = "Which symbols are the systems made of, and do the names of parameters matter?",
    .source = "[Liebemann2017] sec. 2.1, 2.2, 4.2.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
