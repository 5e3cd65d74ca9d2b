// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/lsystem/bench_systems.hpp"
#include "benchmarks/lsystem/derivation_race.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

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

constexpr const char* row_text =
    "axiom: A(1)\n"
    "A(x) < A(y) > A(z) -> A((x + y + z) / 3)\n";

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

std::vector<double> row_values(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i * i % 1'009));
  return values;
}

/// The same means in an array: equal bits, since the sums have the same order.
std::string objection_to_row(std::size_t count, int steps, const Word& word) {
  std::vector<double> values = row_values(count), next = values;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 1; i + 1 < count; ++i)
      next[i] = (values[i - 1] + values[i] + values[i + 1]) / 3;
    values = next;
  }
  if (word.size() != count || word.parameters.size() != count)
    return fmt::format("{} modules instead of {}", word.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    if (word.parameters[i] != values[i])
      return fmt::format("module {} has {} instead of {}", i, word.parameters[i], values[i]);
  return "";
}

/// The most steps from `first` to `last` that keep the word within so many modules; none if not
/// even the first does.
std::optional<int> steps_within(const LSystem& system, int first, int last,
                                std::uint64_t most_modules) {
  std::optional<int> steps;
  for (int n = first; n <= last; ++n) {
    const auto length =
        oracles::word_length(oracles::letter_counts(structure_of(system), n)).in_64_bits();
    if (length && *length <= most_modules) steps = n;
  }
  return steps;
}

}  // namespace

std::vector<DerivationCase> derivation_cases(std::uint64_t most_modules) {
  std::vector<DerivationCase> cases;
  const LSystem tree = parse_lsystem(tree_text, "eq. 2.17");
  for (int n = 8; n <= steps_within(tree, 8, 13, most_modules).value_or(0); ++n)
    cases.push_back({"tree, parametric", tree, n, true,
                     [tree, n](const Word& word) { return objection_to_tree(tree, n, word); }});
  const LSystem bush = parse_lsystem(bush_text, "eq. 7");
  if (const auto n = steps_within(bush, 5, 12, most_modules))
    for (const bool every_word : {true, false})
      cases.push_back(
          {every_word ? "bush, every word" : "bush, last word alone", bush, *n, every_word,
           [bush, n](const Word& word) { return objection_to_counts(bush, *n, word); }});
  constexpr std::uint64_t longest_row = 1'000'000;
  constexpr int row_steps = 10;
  const auto count =
      static_cast<std::size_t>(std::clamp<std::uint64_t>(most_modules, 3, longest_row));
  LSystem row = parse_lsystem(row_text, "row");
  const SymbolIndex symbol = row.axiom.front().symbol;
  row.axiom.clear();
  for (const double value : row_values(count)) row.axiom.push_back({symbol, {value}});
  cases.push_back({"row, parametric, contexts", row, row_steps, true,
                   [count](const Word& word) { return objection_to_row(count, row_steps, word); }});
  return cases;
}

}  // namespace phytobench
