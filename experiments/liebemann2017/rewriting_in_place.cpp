// SPDX-License-Identifier: MIT
// All letters at once (sec. 2.2), or one after the other in the same string (the end of sec. 2.1,
// sec. 4.2.2): which orders give the words of the definition?
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/word_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

/// One production after the other, each replacing what it finds in the string that the ones before
/// it left.
Word derived_in_turn(const LSystem& system, int steps, const std::vector<std::size_t>& order) {
  Word word = axiom_word(system);
  for (int step = 0; step < steps; ++step)
    for (const std::size_t production : order) {
      LSystem single = with_axiom(system, word);
      single.productions = {system.productions[production]};
      word = derived(single, 1);
    }
  return word;
}

std::vector<std::size_t> printed_order(const LSystem& system) {
  std::vector<std::size_t> order(system.productions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Orders of the productions, and how many of them give the words of the definition.
void measure_orders(ExperimentContext& context, const std::string& name, const LSystem& system,
                    int steps) {
  std::vector<std::size_t> order = printed_order(system);
  std::int64_t orders = 0, right = 0, right_as_printed = 0;
  const std::string hash = word_hash(system, derived(system, steps));
  do {
    const bool is_right = word_hash(system, derived_in_turn(system, steps, order)) == hash;
    right_as_printed += is_right && orders == 0;
    right += is_right;
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  context.record(name + "/orders", orders, "orders");
  context.record(name + "/right_orders", right, "orders");
  context.record(name + "/printed_order_is_right", right_as_printed);
}

LSystem swap_system() {
  return parse_lsystem("axiom: ABAB\nA -> B\nB -> A\n", "swap");
}

/// The literal readings beside the definition, for all systems without parameters.
void measure_literal_readings(ExperimentContext& context) {
  const std::pair<std::string, literal::D0LSystem> systems[] = {
      {"eq-2.1", literal::equation_2_1()},
      {"eq-2.6", literal::equation_2_6()},
      {"fig-2.5a", literal::figure_2_5a()},
      {"fig-2.5b", literal::figure_2_5b()}};
  const LSystem ours[] = {anabaena_system(), koch_system(1.0), plant_a_system(), plant_b_system()};
  constexpr int steps = 3;
  for (std::size_t i = 0; i < std::size(systems); ++i) {
    const std::string& name = systems[i].first;
    const literal::D0LSystem& G = systems[i].second;
    const std::string separator = name == "eq-2.1" ? " " : "";
    std::int64_t wrong = 0, wrong_in_turn = 0, wrong_behind = 0, wrong_next = 0, endless = 0;
    for (int n = 0; n <= steps; ++n) {
      const std::string word = word_after(ours[i], n);
      const auto is_other = [&](const literal::Letters& found) {
        return literal::joined(found, separator) != word;
      };
      wrong += is_other(literal::derive_in_parallel(G, n));
      wrong_in_turn += is_other(literal::derive_rule_after_rule(G, n));
      const auto behind = literal::derive_left_to_right(G, n, literal::GoOn::behind_the_successor,
                                                        std::size_t{100'000});
      wrong_behind += !behind || is_other(*behind);
      const auto next =
          literal::derive_left_to_right(G, n, literal::GoOn::at_the_next_letter, std::size_t{1000});
      endless += !next;
      wrong_next += next && is_other(*next);
    }
    context.record(name + "/words", std::int64_t{steps + 1}, "words");
    context.record(name + "/differs_from_oracle", wrong, "words");
    context.record(name + "/production_after_production_differs", wrong_in_turn, "words");
    context.record(name + "/left_to_right_differs", wrong_behind, "words");
    context.record(name + "/at_the_next_letter_differs", wrong_next, "words");
    context.record(name + "/at_the_next_letter_endless", endless, "words");
  }
}

void measure_words(ExperimentContext& context) {
  const LSystem swap = swap_system(), anabaena = anabaena_system(),
                parametric = parametric_system();
  context.record("swap/at_once", word_after(swap, 1));
  context.record("swap/in_turn", text_of(swap, derived_in_turn(swap, 1, printed_order(swap))));
  for (int n = 1; n <= 4; ++n) {
    const Word word = derived_in_turn(anabaena, n, printed_order(anabaena));
    if (n == 1) context.record("eq-2.1/in_turn/word", text_of(anabaena, word));
    context.record(fmt::format("eq-2.1/in_turn/n-{}/cells", n), whole(word.size()), "cells");
  }
  context.record("eq-2.2/in_turn/word",
                 text_of(parametric, derived_in_turn(parametric, 1, printed_order(parametric))));
}

/// What the order of its two productions makes of the tree of figure 2.6.
void measure_tree(ExperimentContext& context) {
  const LSystem tree = space_tree_system(pitch_a_deg);
  const auto length_of = [&](const Word& word) {
    double length = 0.0;
    for (const TurtleSegment& segment : draw(tree, word).segments)
      length += norm(segment.to - segment.from);
    return length;
  };
  const double at_once = length_of(derived(tree, space_tree_steps));
  const double in_turn = length_of(derived_in_turn(tree, space_tree_steps, printed_order(tree)));
  context.record("eq-2.17/length_in_turn_by_length_at_once", in_turn / at_once);
}

void run(ExperimentContext& context) {
  measure_literal_readings(context);
  measure_orders(context, "eq-2.1", anabaena_system(), 5);
  measure_orders(context, "eq-2.2", parametric_system(), 5);
  measure_orders(context, "eq-2.6", koch_system(1.0), 3);
  measure_orders(context, "fig-2.5a", plant_a_system(), 3);
  measure_orders(context, "fig-2.5b", plant_b_system(), 3);
  measure_orders(context, "eq-2.17", space_tree_system(pitch_a_deg), 4);
  measure_orders(context, "swap", swap_system(), 1);
  measure_words(context);
  measure_tree(context);
}

}  // namespace

extern const ExperimentDescriptor rewriting_in_place;
constinit const ExperimentDescriptor rewriting_in_place{
    .id = "liebemann2017/rewriting-in-place",
    .question = "Which orders of replacing in one string are as good as replacing all at once?",
    .source = "[Liebemann2017] sec. 2.1, 2.2, 4.2.2",
    .seconds = {0.7, 0.7, 0.7},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
