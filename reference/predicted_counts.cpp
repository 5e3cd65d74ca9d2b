// SPDX-License-Identifier: MIT
#include "reference/predicted_counts.hpp"

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

std::optional<PredictedSymbols> predicted_symbols(const LSystem& system, int steps) {
  PHYTOBENCH_EXPECT(steps >= 0);
  constexpr double most_work = 4e8;  // some seconds
  if (!kind_of(system).has_fixed_successors()) return std::nullopt;
  const auto counted = oracles::letter_counts_within(translated(system), steps, most_work);
  if (!counted) return std::nullopt;
  const LetterCounts& counts = *counted;
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
