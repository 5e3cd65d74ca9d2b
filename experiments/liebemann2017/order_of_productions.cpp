// SPDX-License-Identifier: MIT
// Sec. 4.2.2 at its word: when is one production after the other, in the same string, a derivation?
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/word_systems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

using Order = std::vector<std::size_t>;

/// The word after one step in which each production replaces what the ones before it left.
Word stepped_in_turn(const LSystem& system, const Word& from, const Order& order) {
  Word word = copy_of(from);
  for (const std::size_t production : order) {
    LSystem single = with_axiom(system, word);
    single.productions = {system.productions[production]};
    word = derived(single, 1);
  }
  return word;
}

/// Whether some production writes what a later one replaces.
bool reads_what_was_written(const LSystem& system, const Order& order) {
  for (std::size_t first = 0; first < order.size(); ++first)
    for (std::size_t later = first + 1; later < order.size(); ++later) {
      const SymbolIndex replaced = system.productions[order[later]].predecessor.symbol;
      for (const SuccessorModule& module : system.productions[order[first]].successor)
        if (module.symbol == replaced) return true;
    }
  return false;
}

Order printed_order_of(const LSystem& system) {
  Order order(system.productions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Orders of eq. 2.1 that are right after n steps.
void measure_anabaena(ExperimentContext& context) {
  const LSystem system = anabaena_system();
  for (int n = 1; n <= 4; ++n) {
    Order order = printed_order_of(system);
    std::int64_t right = 0, orders = 0, safe = 0;
    do {
      Word word = axiom_word(system);
      for (int step = 0; step < n; ++step) word = stepped_in_turn(system, word, order);
      right += text_of(system, word) == word_after(system, n);
      safe += !reads_what_was_written(system, order);
      ++orders;
    } while (std::next_permutation(order.begin(), order.end()));
    const std::string name = fmt::format("eq-2.1/n-{}/", n);
    context.record(name + "right_orders", right, "orders");
    if (n > 1) continue;
    context.record("eq-2.1/orders", orders, "orders");
    context.record("eq-2.1/orders_that_read_nothing_written", safe, "orders");
  }
}

/// A system with a production for each of four letters; longer successors for later letters.
LSystem random_system(RandomWords& random) {
  std::string text = "axiom: ABCD\n";
  for (const char letter : {'A', 'B', 'C', 'D'}) {
    std::string successor;
    for (int length = random.below(4); length > 0; --length) successor += "ABCDEF"[random.below(6)];
    text += std::string(1, letter) + " -> " + (successor.empty() ? "*" : successor) + "\n";
  }
  return parse_lsystem(text, "random system");
}

/// Orders that read nothing written, and the others, of systems that nobody chose.
void measure_random_systems(ExperimentContext& context) {
  const int systems = context.tier() == Tier::smoke ? 60 : 300;
  RandomWords random(context.seed(), 12, "+");
  std::int64_t safe = 0, safe_and_wrong = 0, unsafe = 0, unsafe_and_wrong = 0;
  for (int i = 0; i < systems; ++i) {
    const LSystem system = random_system(random);
    const Word axiom = axiom_word(system);
    const std::string expected = word_after(system, 1);
    Order order = printed_order_of(system);
    do {
      const bool is_safe = !reads_what_was_written(system, order);
      const bool is_wrong = text_of(system, stepped_in_turn(system, axiom, order)) != expected;
      (is_safe ? safe : unsafe) += 1;
      (is_safe ? safe_and_wrong : unsafe_and_wrong) += is_wrong;
    } while (std::next_permutation(order.begin(), order.end()));
  }
  record_seeded(context, "random/systems", std::int64_t{systems}, "systems");
  record_seeded(context, "random/orders_that_read_nothing_written", safe, "orders");
  record_seeded(context, "random/of_these_wrong", safe_and_wrong, "orders");
  record_seeded(context, "random/other_orders", unsafe, "orders");
  record_seeded(context, "random/of_the_others_wrong", unsafe_and_wrong, "orders");
}

void run(ExperimentContext& context) {
  measure_anabaena(context);
  measure_random_systems(context);
}

}  // namespace

extern const ExperimentDescriptor order_of_productions;
constinit const ExperimentDescriptor order_of_productions{
    .id = "liebemann2017/order-of-productions",
    .question = "When is one production after the other, in one string, still a derivation?",
    .source = "[Liebemann2017] sec. 4.2.2",
    .seconds = {0.2, 0.5, 0.5},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
