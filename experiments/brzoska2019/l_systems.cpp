// SPDX-License-Identifier: MIT
// What sec. 3.4.2 says of D0L-systems, tried on the suite's: words, one step for all letters at
// once, letters without a production, one result, no influence of neighbours.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/brzoska2019_l_systems.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

namespace literal = oracles::brzoska2019;

std::vector<std::string> all_texts() {
  return {equation_4_text, equation_5_text, equation_6_text, equation_7_text()};
}

void record_words(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_4_text);
  for (int n = 0; n <= 12; ++n) {
    const std::string word = word_after(system, n);
    if (n <= 5) context.record(fmt::format("equation-4/n-{}/word", n), word);
    context.record(fmt::format("equation-4/n-{}/letters", n), whole(word.size()), "letters");
  }
  const std::array literals = {literal::equation_4(), literal::equation_5(),
                               literal::equation_6_corrected(), literal::equation_7()};
  const std::array most_steps = {20, 7, 7, 6};
  std::int64_t compared = 0, differ = 0;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    const LSystem ours = thesis_l_system(all_texts()[i]);
    for (int n = 0; n <= most_steps[i]; ++n, ++compared)
      differ += word_after(ours, n) != literal::derive(literals[i], n);
  }
  context.record("oracle/words", compared, "words");
  context.record("oracle/differ", differ, "words");
}

/// What ab becomes if one production has done its work before the next begins.
std::string one_after_the_other(const std::string& first, const std::string& second) {
  const std::string between = word_after(thesis_l_system("axiom: ab\n" + first), 1);
  return word_after(with_axiom(thesis_l_system("axiom: ab\n" + second), between), 1);
}

void record_parallel(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_4_text);
  context.record("parallel/at_once", word_after(with_axiom(system, "ab"), 1));
  context.record("parallel/p1_then_p2", one_after_the_other("b -> a\n", "a -> ab\n"));
  context.record("parallel/p2_then_p1", one_after_the_other("a -> ab\n", "b -> a\n"));
}

std::string without_a_and_b(std::string word) {
  std::erase_if(word, [](char letter) { return letter == 'a' || letter == 'b'; });
  return word;
}

void record_identity(ExperimentContext& context) {
  CounterStream stream(context.seed(), 1);
  const LSystem system = thesis_l_system(equation_4_text);
  constexpr std::int64_t words = 500;
  std::int64_t changed_alone = 0, changed_among_others = 0;
  for (std::int64_t i = 0; i < words; ++i) {
    const std::string alone = random_letters(stream, "cdxyzF+-&^!", 20);
    changed_alone += word_after(with_axiom(system, alone), 3) != alone;
    const std::string among = random_letters(stream, "abcdxyzF+-", 40);
    const std::string after = word_after(with_axiom(system, among), 3);
    changed_among_others += without_a_and_b(after) != without_a_and_b(among);
  }
  context.record("identity/words", words, "words");
  context.record("identity/changed_alone", changed_alone, "words");
  context.record("identity/changed_among_others", changed_among_others, "words");
}

void record_determinism(ExperimentContext& context) {
  std::int64_t compared = 0, differ = 0, seconds = 0, refused = 0;
  for (const std::string& text : all_texts()) {
    const LSystem system = thesis_l_system(text);
    const std::string once = word_hash(system, derived(system, 6));
    for (const int threads : {1, 2, 3})
      for (std::uint64_t seed = 0; seed < 4; ++seed, ++compared) {
        DeriveOptions options;
        options.steps = 6;
        options.threads = threads;
        options.seed = context.seed() + seed;
        differ += word_hash(system, derive(system, options)) != once;
      }
    for (const Production& production : system.productions) {
      const std::string& letter = system.symbols[production.predecessor.symbol].letter;
      refused += is_refused(fmt::format("{}{} -> {}{}\n", text, letter, letter, letter));
      ++seconds;
    }
  }
  context.record("determinism/derivations", compared, "derivations");
  context.record("determinism/differ", differ, "derivations");
  context.record("determinism/second_productions", seconds, "systems");
  context.record("determinism/refused", refused, "systems");
}

/// All x a y over an alphabet, plain and with a in a branch, beside x, a and y alone.
void record_neighbours(ExperimentContext& context) {
  const std::array alphabets = {"ab", "F-+", "FX-+", "FfASL-+|&^\\/'!"};
  std::int64_t words = 0, differ = 0;
  for (std::size_t i = 0; i < alphabets.size(); ++i) {
    context.progress("neighbours in equation " + std::to_string(i + 4));
    const LSystem system = thesis_l_system(all_texts()[i]);
    const std::string letters = alphabets[i];
    std::vector<std::string> alone;
    for (const char letter : letters)
      alone.push_back(word_after(with_axiom(system, std::string(1, letter)), 1));
    for (std::size_t x = 0; x < letters.size(); ++x)
      for (std::size_t a = 0; a < letters.size(); ++a)
        for (std::size_t y = 0; y < letters.size(); ++y)
          for (const bool branch : {false, true}) {
            const std::string open = branch ? "[" : "", close = branch ? "]" : "";
            const std::string word = letters[x] + open + letters[a] + close + letters[y];
            differ += word_after(with_axiom(system, word), 1) !=
                      alone[x] + open + alone[a] + close + alone[y];
            ++words;
          }
  }
  context.record("neighbours/words", words, "words");
  context.record("neighbours/differ", differ, "words");
}

/// What the definition demands of axiom, predecessor and successor.
void record_definition(ExperimentContext& context) {
  context.record("definition/empty_axiom_refused", std::int64_t{is_refused("axiom:\na -> ab\n")});
  context.record("definition/two_letters_replaced_refused",
                 std::int64_t{is_refused("axiom: ab\nab -> a\n")});
  const LSystem system = thesis_l_system("axiom: aba\na -> *\n");
  context.record("definition/erased", word_after(system, 1));
}

void run(ExperimentContext& context) {
  record_words(context);
  record_parallel(context);
  record_identity(context);
  record_determinism(context);
  record_neighbours(context);
  record_definition(context);
}

}  // namespace

extern const ExperimentDescriptor l_systems;
constinit const ExperimentDescriptor l_systems{
    .id = "brzoska2019/l-systems",
    .question = "Do L-systems replace letters as the thesis says?",
    .source = "[Brzoska2019] sec. 3.4.2, eq. 4-7",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
