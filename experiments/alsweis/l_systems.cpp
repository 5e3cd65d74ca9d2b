// SPDX-License-Identifier: MIT
// L-system 1: all its words with their exact probabilities, found by deriving every choice in turn.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/alsweis/chapter_3_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_lsystems.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace literal = oracles::alsweis;
/// One step of every word, with every choice in turn: an A that p2 is to replace is called C, and
/// contexts take both for an A. The suite derives each of them; nothing is drawn.
WordLaw next_words(const WordLaw& words) {
  WordLaw next;
  for (const auto& [word, probability] : words) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < word.size(); ++i)
      if (word[i] == 'A') places.push_back(i);
    for (std::size_t choice = 0; choice < std::size_t{1} << places.size(); ++choice) {
      std::string chosen = word;
      literal::FifthsProbability p = probability;
      for (std::size_t k = 0; k < places.size(); ++k) {
        const bool by_p2 = (choice >> k & 1) != 0;
        if (by_p2) chosen[places[k]] = 'C';
        p = literal::product(
            p, by_p2 ? literal::FifthsProbability{3, 5} : literal::FifthsProbability{2, 5});
      }
      std::string text = "axiom: " + chosen + "\nA(x) -> A(x + 1)\nC(x) -> B(x - 1)\n";
      for (const char* sides : {"AA", "AC", "CA", "CC"})
        text += fmt::format("{}(x) < B(y) > {}(z) : y < 4 -> B(x + z)[A(y)]\n", sides[0], sides[1]);
      literal::FifthsProbability& sum = next[word_after(l_system(text), 1)];
      sum = sum.numerator == 0 ? p : literal::sum(sum, p);
    }
  }
  return next;
}

void record_all_words(ExperimentContext& context) {
  WordLaw ours{{"A(1)B(3)A(5)", {1, 1}}};
  for (int n = 1; n <= most_steps_of_l_system_1; ++n) {
    ours = next_words(ours);
    const WordLaw law = literal::outcomes_of_lsystem_1(n);
    const std::string name = fmt::format("l-system-1/n-{}/", n);
    context.record(name + "words", whole(ours.size()), "words");
    std::int64_t differ = 0, other_pairs = 0;
    for (const auto& [word, p] : ours) {
      const auto found = law.find(word);
      differ += found == law.end() || !(found->second == p);
      other_pairs += std::count(word.begin(), word.end(), '[') != 1;
    }
    context.record(name + "differ_from_oracle",
                   differ + std::abs(whole(ours.size()) - whole(law.size())), "words");
    context.record(name + "words_without_exactly_one_branch", other_pairs, "words");
    double all = 0.0, letters_A = 0.0;
    for (const auto& [word, p] : ours) {
      all += value_of(p);
      letters_A += value_of(p) * static_cast<double>(std::count(word.begin(), word.end(), 'A'));
    }
    context.record(name + "sum_of_probabilities", all);
    context.record(name + "expected_a", letters_A, "letters");
    if (n == 1)
      for (const auto& [word, p] : ours)
        context.record("l-system-1/n-1/" + name_of_word(word), value_of(p));
  }
}

void run(ExperimentContext& context) {
  record_all_words(context);
}

}  // namespace

extern const ExperimentDescriptor l_systems;
constinit const ExperimentDescriptor l_systems{
    .id = "alsweis/l-systems",
    .question = "Which words does L-system 1 derive, and with which probabilities?",
    .source = "[Alsweis] section 3.2, L-system 1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
