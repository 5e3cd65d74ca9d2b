// SPDX-License-Identifier: MIT
// What the definitions of ch. 2 demand of axioms, productions and derivations.
#include <algorithm>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/word_systems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// What the definition demands.
void measure_definition(ExperimentContext& context) {
  const LSystem system = parametric_system();
  context.record("definition/symbols", whole(system.symbols.size()), "symbols");
  context.record("definition/conditions", std::int64_t{kind_of(system).conditional} +
                                              kind_of(space_tree_system(pitch_a_deg)).conditional);
  context.record("definition/empty_axiom_refused", std::int64_t{is_refused("axiom:\nA -> B\n")});
  context.record("definition/variable_in_axiom_refused",
                 std::int64_t{is_refused("axiom: A(x)\nA(x) -> A(x + 1)\n")});
  context.record("definition/unknown_variable_refused",
                 std::int64_t{is_refused("axiom: A(1)\nA(x) -> A(z)\n")});
  context.record("definition/variable_of_other_production_refused",
                 std::int64_t{is_refused("axiom: A(1)B(1)\nA(x) -> A(x)\nB(y) -> B(x)\n")});
  std::int64_t refused = 0;
  for (const char* expression : {"x +", "* x", "x y", "x + / 2", "x + 1)", "2 x"})
    refused += is_refused(fmt::format("axiom: A(1)\nA(x) -> A({})\n", expression));
  context.record("definition/invalid_expressions_refused", refused, "expressions");
  context.record("definition/real_parameters",
                 word_after(parametric_system("A(0.5,-3)B(-1.25)"), 1));
  std::int64_t d0l = 0;
  for (const LSystem& plain :
       {anabaena_system(), koch_system(1.0), plant_a_system(), plant_b_system()})
    d0l += kind_of(plain).is_d0l();
  context.record("definition/d0l_systems", d0l, "systems");
  context.record("definition/parametric_is_d0l", std::int64_t{kind_of(system).is_d0l()});
}

/// Derivations of letters: what a production may replace and make, and n of them in a row.
void measure_derivation(ExperimentContext& context) {
  context.record("derivation/two_letters_replaced_refused",
                 std::int64_t{is_refused("axiom: AB\nAB -> A\n")});
  context.record("derivation/second_production_refused",
                 std::int64_t{is_refused("axiom: A\nA -> B\nA -> C\n")});
  context.record("derivation/erased",
                 word_after(parse_lsystem("axiom: ABA\nB -> *\n", "erasing"), 1));
  const LSystem systems[] = {anabaena_system(), parametric_system(), koch_system(1.0)};
  std::int64_t not_composed = 0, words = 0;
  for (const LSystem& system : systems)
    for (int n = 0; n <= 3; ++n, ++words)
      not_composed +=
          word_after(system, n + 1) != word_after(with_axiom(system, derived(system, n)), 1);
  context.record("derivation/words", words, "words");
  context.record("derivation/n_and_one_is_not_n_plus_1", not_composed, "words");
  // Signs that no production replaces, as the C of eq. 2.2 and the turns of eq. 2.6.
  const auto without = [](const LSystem& system) {
    std::vector<bool> replaced(system.symbols.size(), false);
    for (const Production& production : system.productions)
      replaced[production.predecessor.symbol] = true;
    return std::count(replaced.begin(), replaced.end(), false);
  };
  context.record("derivation/eq-2.1/without_production", std::int64_t{without(systems[0])});
  context.record("derivation/eq-2.2/without_production", std::int64_t{without(systems[1])});
  context.record("derivation/eq-2.6/without_production", std::int64_t{without(systems[2])});
  std::int64_t modules = 0, with_one_parameter = 0;
  for (const Production& production : systems[1].productions)
    for (const SuccessorModule& module : production.successor) {
      ++modules;
      with_one_parameter += module.parameters.size() == 1;
    }
  context.record("derivation/eq-2.2/successor_modules", modules, "modules");
  context.record("derivation/eq-2.2/with_one_parameter", with_one_parameter, "modules");
  context.record("derivation/eq-2.17/axiom_modules",
                 whole(space_tree_system(pitch_a_deg).axiom.size()), "modules");
}

void run(ExperimentContext& context) {
  measure_definition(context);
  measure_derivation(context);
}

}  // namespace

extern const ExperimentDescriptor definitions;
constinit const ExperimentDescriptor definitions{
    .id = "liebemann2017/definitions",
    .question = "Which systems are L-systems by the definitions, and what is a derivation?",
    .source = "[Liebemann2017] sec. 2.1, 2.2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
