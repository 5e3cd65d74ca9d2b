// SPDX-License-Identifier: MIT
// Eq. 2.2 and figure 2.2, and which productions a module with parameters fits.
#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/word_systems.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

void measure_words(ExperimentContext& context) {
  constexpr int last = 14;
  const LSystem system = parametric_system();
  std::int64_t differ = 0, other_form = 0;
  for (int n = 0; n <= last; ++n) {
    const Word word = derived(system, n);
    const std::string text = text_of(system, word), name = fmt::format("n-{}/", n);
    if (n <= 4) context.record(name + "word", text);
    if (n <= 8) {
      context.record(name + "modules", whole(word.size()), "modules");
      context.record(name + "B", letter_count(system, word, "B"), "modules");
      context.record(name + "C", letter_count(system, word, "C"), "modules");
    }
    differ += literal_word(system, word) != literal::derive(literal::equation_2_2(), n);
    other_form +=
        text != oracles::equation_2_2_word(n) || word.size() != oracles::equation_2_2_modules(n);
  }
  context.record("words", std::int64_t{last + 1}, "words");
  context.record("differs_from_oracle", differ, "words");
  context.record("differs_from_closed_form", other_form, "words");
}

/// All modules of four letters with none to four parameters, each as a word of its own.
void measure_matching(ExperimentContext& context) {
  std::int64_t modules = 0, replaced = 0, wrongly = 0;
  for (const char letter : {'A', 'B', 'C', 'D'})
    for (int parameters = 0; parameters <= 4; ++parameters, ++modules) {
      std::string module(1, letter);
      for (int k = 1; k <= parameters; ++k) module += fmt::format("{}{}", k == 1 ? "(" : ",", k);
      if (parameters > 0) module += ")";
      const bool changed = word_after(parametric_system(module), 1) != module;
      replaced += changed;
      wrongly +=
          changed != ((letter == 'A' && parameters == 2) || (letter == 'B' && parameters == 1));
    }
  context.record("matching/modules", modules, "modules");
  context.record("matching/replaced", replaced, "modules");
  context.record("matching/wrongly", wrongly, "modules");
  context.record(
      "matching/one_letter_two_productions",
      word_after(parse_lsystem("axiom: A A(1) A(1,2)\nA -> B\nA(x) -> C(x)\n", "text"), 1));
}

/// Words that nobody chose, with real parameters: replaced module by module.
void measure_random_words(ExperimentContext& context) {
  constexpr int words = 200;
  RandomWords random(context.seed(), 9, "+");
  std::int64_t different = 0, modules = 0, untouched_changed = 0, untouched = 0, by_neighbours = 0;
  for (int i = 0; i < words; ++i) {
    oracles::ParametricWord word;
    for (int k = 0; k < 12; ++k) {
      oracles::Module module;
      module.letter = std::string(1, "ABC"[random.below(3)]);
      for (int p = random.below(4); p > 0; --p)
        module.parameters.push_back((random.below(2000) - 1000) / 8.0);
      word.push_back(std::move(module));
    }
    literal::ParametricLSystem G = literal::equation_2_2();
    G.omega = word;
    const LSystem system = parametric_system(oracles::text_of(word));
    different += literal_word(system, derived(system, 3)) != literal::derive(G, 3);
    modules += whole(word.size());
    std::string alone;
    for (const oracles::Module& module : word)
      alone += word_after(parametric_system(oracles::text_of({module})), 3);
    by_neighbours += word_after(system, 3) != alone;
    std::erase_if(word, [](const oracles::Module& m) {
      return (m.letter == "A" && m.parameters.size() == 2) ||
             (m.letter == "B" && m.parameters.size() == 1);
    });
    if (word.empty()) continue;
    const std::string rest = oracles::text_of(word);
    untouched_changed += word_after(parametric_system(rest), 3) != rest;
    ++untouched;
  }
  record_seeded(context, "random-words/words", std::int64_t{words}, "words");
  record_seeded(context, "random-words/modules", modules, "modules");
  record_seeded(context, "random-words/differs_from_oracle", different, "words");
  record_seeded(context, "random-words/changed_by_neighbours", by_neighbours, "words");
  record_seeded(context, "random-words/without_production", untouched, "words");
  record_seeded(context, "random-words/without_production_changed", untouched_changed, "words");
}

void run(ExperimentContext& context) {
  measure_words(context);
  measure_matching(context);
  measure_random_words(context);
}

}  // namespace

extern const ExperimentDescriptor parametric_words;
constinit const ExperimentDescriptor parametric_words{
    .id = "liebemann2017/parametric-words",
    .question = "Which words does an L-system with parameters make?",
    .source = "[Liebemann2017] sec. 2.2.1, eq. 2.2, fig. 2.2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
