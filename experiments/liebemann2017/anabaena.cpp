// SPDX-License-Identifier: MIT
// Eq. 2.1 and figure 2.1: a filament of cells that divide and grow.
#include <algorithm>
#include <cmath>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/filament_svg.hpp"
#include "experiments/liebemann2017/word_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

/// Letters of the word, "ar" as one.
literal::Letters cells(const LSystem& system, int steps) {
  return literal::between_blanks(word_after(system, steps));
}

std::int64_t count_if_first(const literal::Letters& word, char size) {
  return std::count_if(word.begin(), word.end(),
                       [size](const std::string& cell) { return cell[0] == size; });
}

void measure_words(ExperimentContext& context) {
  constexpr int last_word = 5, last_count = 20;
  const LSystem system = anabaena_system();
  std::int64_t differ = 0, other_counts = 0, other_increase = 0;
  literal::Letters before;
  for (int n = 0; n <= last_count; ++n) {
    const literal::Letters word = cells(system, n);
    const std::string name = fmt::format("n-{}/", n);
    if (n <= last_word) context.record(name + "word", literal::joined(word, " "));
    if (n <= 12) {
      context.record(name + "cells", whole(word.size()), "cells");
      context.record(name + "big_cells", count_if_first(word, 'a'), "cells");
    }
    differ += word != literal::derive_in_parallel(literal::equation_2_1(), n);
    other_counts +=
        word.size() != oracles::equation_2_1_cells(n) ||
        static_cast<std::uint64_t>(count_if_first(word, 'a')) != oracles::equation_2_1_big_cells(n);
    // Big cells divide, small ones do not.
    if (n > 0)
      other_increase += whole(word.size()) != whole(before.size()) + count_if_first(before, 'a');
    before = word;
  }
  context.record("words", std::int64_t{last_count + 1}, "words");
  context.record("differs_from_oracle", differ, "words");
  context.record("differs_from_closed_form", other_counts, "words");
  context.record("increase_is_not_big_cells", other_increase, "words");
}

/// The word seen from its other end: the order of cells and the polarity of each are turned.
literal::Letters mirrored(literal::Letters word) {
  std::reverse(word.begin(), word.end());
  for (std::string& cell : word) cell[1] = cell[1] == 'l' ? 'r' : 'l';
  return word;
}

/// What follows from the four productions for words of any length.
void measure_structure(ExperimentContext& context) {
  const LSystem from_r = anabaena_system("ar"), from_l = anabaena_system("al");
  std::int64_t not_mirrored = 0, not_composed = 0, small_neighbours = 0, three_big = 0;
  for (int n = 0; n <= 14; ++n) {
    const literal::Letters word = cells(from_r, n);
    not_mirrored += mirrored(word) != cells(from_l, n);
    for (std::size_t i = 1; i < word.size(); ++i)
      small_neighbours += word[i - 1][0] == 'b' && word[i][0] == 'b';
    for (std::size_t i = 3; i < word.size(); ++i)
      three_big += word[i][0] == 'a' && word[i - 1][0] == 'a' && word[i - 2][0] == 'a';
    if (n < 2) continue;
    // a_r becomes a_l b_r, and b_r an a_r one step later.
    literal::Letters composed = cells(from_l, n - 1);
    const literal::Letters rest = cells(from_r, n - 2);
    composed.insert(composed.end(), rest.begin(), rest.end());
    not_composed += word != composed;
  }
  context.record("structure/words", std::int64_t{15}, "words");
  context.record("structure/not_mirrored", not_mirrored, "words");
  context.record("structure/not_composed", not_composed, "words");
  context.record("structure/small_beside_small", small_neighbours, "places");
  context.record("structure/three_big_cells_in_a_row", three_big, "places");
}

/// Long filaments, counted only.
void measure_growth(ExperimentContext& context) {
  constexpr int steps = 80;
  const LSystem system = anabaena_system();
  const std::optional<GrowthForecast> forecast = growth_forecast(system, steps);
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  std::int64_t different = 0;
  double big = 0.0;
  for (int n = 0; n <= steps; ++n) {
    const GrowthForecast::Step& step = forecast->steps[static_cast<std::size_t>(n)];
    std::uint64_t big_cells = 0;
    for (std::size_t i = 0; i < system.symbols.size(); ++i)
      if (system.symbols[i].letter[0] == 'a') big_cells += step.symbols[i];
    different += step.modules != oracles::equation_2_1_cells(n) ||
                 big_cells != oracles::equation_2_1_big_cells(n);
    big = static_cast<double>(big_cells) / static_cast<double>(step.modules);
  }
  context.record("growth/steps", std::int64_t{steps}, "steps");
  context.record("growth/differs_from_closed_form", different, "steps");
  context.record("growth/factor_off_golden_section",
                 std::abs(static_cast<double>(forecast->steps[steps].modules) /
                              static_cast<double>(forecast->steps[steps - 1].modules) -
                          golden));
  context.record("growth/share_of_big_cells_off_golden_section", std::abs(big - 1.0 / golden));
}

/// What each cell becomes in one step.
void measure_productions(ExperimentContext& context) {
  for (const std::string cell : {"ar", "al", "br", "bl"})
    context.record("successor_of_" + cell, word_after(anabaena_system(cell), 1));
}

void run(ExperimentContext& context) {
  measure_words(context);
  measure_structure(context);
  measure_growth(context);
  measure_productions(context);
  std::vector<literal::Letters> rows;
  for (int n = 0; n <= 5; ++n) rows.push_back(cells(anabaena_system(), n));
  context.artifact("figure-2.1.svg", filament_svg(rows, "Figure 2.1: 0 to 5 derivations of a_r"));
}

}  // namespace

extern const ExperimentDescriptor anabaena;
constinit const ExperimentDescriptor anabaena{
    .id = "liebemann2017/anabaena",
    .question = "Which cells does the L-system of a filament make?",
    .source = "[Liebemann2017] sec. 2.2, eq. 2.1, fig. 2.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
