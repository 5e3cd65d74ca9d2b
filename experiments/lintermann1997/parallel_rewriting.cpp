// SPDX-License-Identifier: MIT
// Sec. 2.1: productions are applied in parallel, and that changes what a grammar can say.
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace literal = oracles::liebemann2017;

std::string word_after(const std::string& text, int steps) {
  const LSystem system = parse_lsystem(text, "example");
  return text_of(system, derived(system, steps));
}

std::int64_t count(const std::string& word, char letter) {
  return std::count(word.begin(), word.end(), letter);
}

/// a -> b and b -> a, all at once and one production after the other.
void record_swap(ExperimentContext& context) {
  context.record("swap/word_after", word_after("axiom: aab\na -> b\nb -> a\n", 1));
  const literal::D0LSystem G{{"a", "a", "b"}, {{"a", {"b"}}, {"b", {"a"}}}};
  context.record("swap/word_after_one_after_the_other",
                 literal::joined(literal::derive_rule_after_rule(G, 1)));
}

/// Leaves of the bush after each step: in parallel an L of this step is a leaf in the next one.
void record_bush(ExperimentContext& context) {
  const LSystem bush = bush_system(bush_of_the_book());
  for (int n = 1; n <= 2; ++n) {
    const std::string name = "bush/n-" + std::to_string(n) + "/";
    context.record(name + "leaves", count(text_of(bush, derived(bush, n)), '{'));
    const literal::D0LSystem G = oracles::lintermann1997::bush(bush_of_the_book());
    context.record(name + "leaves_one_after_the_other",
                   count(literal::joined(literal::derive_rule_after_rule(G, n)), '{'));
  }
}

constexpr std::size_t longest = 4096;

struct Lengths {
  std::set<std::size_t> all;
  std::size_t longest_gap() const {
    std::size_t gap = 0, before = 0;
    for (const std::size_t length : all)
      gap = std::max(gap, length - std::exchange(before, length));
    return gap;
  }
};

void record(ExperimentContext& context, const Lengths& lengths, const std::string& name) {
  context.record(name + "/lengths_up_to_4096", static_cast<std::int64_t>(lengths.all.size()));
  context.record(name + "/longest_gap", static_cast<std::int64_t>(lengths.longest_gap()));
}

/// The words of a -> aa from a: a^(2^n) in parallel, a^n where one letter is replaced at a time.
void record_doubling(ExperimentContext& context) {
  Lengths parallel, sequential;
  for (int n = 0; n <= 12; ++n) parallel.all.insert(word_after("axiom: a\na -> aa\n", n).size());
  for (std::string word = "a"; word.size() <= longest; word.replace(0, 1, "aa"))
    sequential.all.insert(word.size());
  record(context, parallel, "doubling");
  record(context, sequential, "doubling_one_letter_at_a_time");
}

/// a, b and c doubled from abc: blocks of equal lengths, which no grammar free of context keeps.
void record_three_blocks(ExperimentContext& context) {
  std::int64_t unequal = 0;
  constexpr int last = 10;
  for (int n = 0; n <= last; ++n) {
    const std::string word = word_after("axiom: abc\na -> aa\nb -> bb\nc -> cc\n", n);
    const auto third = static_cast<std::int64_t>(word.size() / 3);
    unequal += count(word, 'a') != third || count(word, 'b') != third ||
               count(word, 'c') != third || !std::is_sorted(word.begin(), word.end());
  }
  context.record("three_blocks/words_of_other_form", unequal);
}

void run(ExperimentContext& context) {
  record_swap(context);
  record_bush(context);
  record_doubling(context);
  record_three_blocks(context);
}

}  // namespace

extern const ExperimentDescriptor parallel_rewriting;
constinit const ExperimentDescriptor parallel_rewriting{
    .id = "lintermann1997/parallel-rewriting",
    .question = "What does it change that all symbols are replaced at once?",
    .source = "[Lintermann1997] sec. 2.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
