// SPDX-License-Identifier: MIT
#include "reference/predicted_counts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "reference/oracles/lsystem_counts.hpp"

namespace phytobench {

namespace {

using oracles::LetterCounts;
using oracles::Natural;

oracles::D0LStructure translated(const LSystem& system) {
  const auto name = [&](SymbolIndex symbol) { return name_of(system.symbols[symbol]); };
  oracles::D0LStructure structure;
  for (const AxiomModule& module : system.axiom) structure.axiom.push_back(name(module.symbol));
  for (const Production& production : system.productions) {
    std::vector<std::string> successor;
    for (const SuccessorModule& module : production.successor)
      successor.push_back(name(module.symbol));
    const bool is_new =
        structure.successors.emplace(name(production.predecessor.symbol), successor).second;
    PHYTOBENCH_EXPECT(is_new);  // successors are fixed
  }
  return structure;
}

ExactCount exact(const Natural& number) {
  return {.digits = number.text(), .number = number.in_64_bits()};
}

/// Digits that the oracle adds at most, about.
double digits_added(const LSystem& system, int steps) {
  std::size_t longest = 1, together = system.symbols.size();
  for (const Production& production : system.productions) {
    longest = std::max(longest, production.successor.size());
    together += production.successor.size();
  }
  const double digits = std::log10(static_cast<double>(system.axiom.size())) +
                        std::log10(static_cast<double>(longest)) * steps + 1.0;
  return digits / 2.0 * static_cast<double>(together) * steps;
}

/// Letters of one character that draw, whatever parameters they have.
bool draws(const LSystem& system, const Symbol& symbol) {
  return symbol.letter.size() == 1 &&
         system.turtle.draws.find(symbol.letter.front()) != std::string::npos;
}

}  // namespace

std::string name_of(const Symbol& symbol) {
  if (symbol.arity == 0) return symbol.letter;
  std::string name = symbol.letter + "(.";
  for (int i = 1; i < symbol.arity; ++i) name += ",.";
  return name + ")";
}

bool is_too_long_to_predict(const LSystem& system, int steps) {
  constexpr double most_digits = 3e8;
  return kind_of(system).has_fixed_successors() && digits_added(system, steps) > most_digits;
}

std::optional<PredictedSymbols> predicted_symbols(const LSystem& system, int steps) {
  PHYTOBENCH_EXPECT(steps >= 0);
  if (!kind_of(system).has_fixed_successors() || is_too_long_to_predict(system, steps))
    return std::nullopt;
  const LetterCounts counts = oracles::letter_counts(translated(system), steps);
  PredictedSymbols predicted;
  Natural segments;
  bool cuts = false;
  for (const Symbol& symbol : system.symbols) {
    const Natural count = oracles::count_of(counts, name_of(symbol));
    if (draws(system, symbol)) segments += count;
    cuts = cuts || symbol.letter == "%";
    predicted.symbols.push_back(exact(count));
  }
  predicted.modules = exact(oracles::word_length(counts));
  if (!cuts) predicted.segments = exact(segments);
  return predicted;
}

std::string symbol_count_disagreement(const LSystem& system, std::span<const std::uint64_t> made,
                                      const PredictedSymbols& predicted) {
  PHYTOBENCH_EXPECT(made.size() == system.symbols.size());
  PHYTOBENCH_EXPECT(predicted.symbols.size() == made.size());
  for (std::size_t i = 0; i < made.size(); ++i)
    if (predicted.symbols[i].number != made[i])
      return fmt::format("the word has {} times '{}' where its matrix counts {}", made[i],
                         name_of(system.symbols[i]), predicted.symbols[i].digits);
  return {};
}

std::string segment_count_disagreement(std::uint64_t drawn, const PredictedSymbols& predicted) {
  if (!predicted.segments || predicted.segments->number == drawn) return {};
  return fmt::format("{} segments are drawn where the matrix of the system counts {}", drawn,
                     predicted.segments->digits);
}

}  // namespace phytobench
