// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/derivation_case.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/lsystem/bench_systems.hpp"
#include "benchmarks/lsystem/literal_word.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench {

namespace {

constexpr const char* tree_text =
    "lr = 1.3\n"
    "axiom: /(45)A\n"
    "A -> F(50)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]\n"
    "F(l) -> F(l * lr)\n";

constexpr const char* bush_text =
    "axiom: A\n"
    "A -> [&FL!A]/////'[&FL!A]///////'[&FL!A]\n"
    "F -> S/////F\n"
    "S -> FL\n"
    "L -> ['''^^{-f+f+f-|-f+f+f}]\n"
    "angle: 22.5\n";

constexpr const char* plant_text =
    "axiom: X\n"
    "X -> F[+++FX]F[---FX]F[++F-FX][F-FX]\n"
    "F -> FF\n"
    "angle: 10\n";

/// Letters counted in the word against the matrix of letters.
std::string objection_to_counts(const LSystem& system, int steps, const Word& word) {
  const oracles::LetterCounts expected = oracles::letter_counts(structure_of(system), steps);
  const std::vector<std::uint64_t> found = symbol_counts(system, word);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Symbol& symbol = system.symbols[i];
    const std::string name =
        symbol.arity == 0 ? symbol.letter : fmt::format("{}/{}", symbol.letter, symbol.arity);
    const oracles::Natural count = oracles::count_of(expected, name);
    if (count != oracles::Natural(found[i]))
      return fmt::format("{} modules {} instead of {}", found[i], name, count.text());
  }
  return "";
}

/// Parameters of all modules of that letter added up.
double parameter_sum(const LSystem& system, const Word& word, const std::string& letter) {
  double sum = 0.0;
  std::size_t parameter = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const Symbol& symbol = system.symbols[word.symbols[i]];
    if (symbol.letter == letter && symbol.arity > 0) sum += word.parameters[parameter];
    parameter += symbol.arity;
  }
  return sum;
}

std::string objection_to_tree(const LSystem& system, int steps, const Word& word) {
  const std::string counts = objection_to_counts(system, steps, word);
  if (!counts.empty()) return counts;
  const auto pairs = static_cast<double>(oracles::equation_2_17_pairs(steps));
  const auto rolls = static_cast<double>(oracles::equation_2_17_A(steps));
  const std::pair<const char*, double> sums[] = {
      {"F", oracles::equation_2_17_drawn_length(steps, 1.3)},
      {"&", 18.95 * pairs},
      {"/", 45.0 + 137.5 * (rolls - 1.0)}};
  for (const auto& [letter, expected] : sums) {
    const double found = parameter_sum(system, word, letter);
    constexpr double rounding = 1e-9;  // of a sum of some million numbers
    if (!(std::abs(found - expected) <= rounding * expected))
      return fmt::format("parameters of {} add up to {:.12g} instead of {:.12g}", letter, found,
                         expected);
  }
  return "";
}

/// Every letter, and the closed form of their number.
std::string objection_to_all_letters(const LSystem& system, int steps, const Word& word,
                                     oracles::Count count) {
  if (word.size() != count) return fmt::format("{} modules instead of {}", word.size(), count);
  return objection_to_letters(system, steps, word);
}

/// A system without parameters, and how many letters its words have.
DerivationCase followed_derivation(const std::string& plant, const char* text, const char* source,
                                   int steps, bool every_word,
                                   const std::function<oracles::Count(int)>& letters) {
  const LSystem system = parse_lsystem(text, source);
  return {plant + (every_word ? ", every word" : ", last word alone"),
          text,
          system,
          steps,
          every_word,
          [system, steps, letters](const Word& word) {
            return objection_to_all_letters(system, steps, word, letters(steps));
          }};
}

}  // namespace

std::uint64_t modules_by_matrix(const LSystem& system, int steps) {
  return oracles::word_length(oracles::letter_counts(structure_of(system), steps))
      .in_64_bits()
      .value_or(std::numeric_limits<std::uint64_t>::max());
}

DerivationCase tree_derivation(int steps) {
  const LSystem system = parse_lsystem(tree_text, "eq. 2.17");
  return {"tree, parametric", tree_text, system, steps, true, [system, steps](const Word& word) {
            return objection_to_tree(system, steps, word);
          }};
}

DerivationCase bush_derivation(int steps, bool every_word) {
  return followed_derivation("bush", bush_text, "eq. 7", steps, every_word,
                             [](int n) { return oracles::lintermann1997::bush_letters(n, {}); });
}

DerivationCase plant_derivation(int steps, bool every_word) {
  return followed_derivation("plant", plant_text, "eq. 6", steps, every_word,
                             oracles::equation_6_letters);
}

}  // namespace phytobench
