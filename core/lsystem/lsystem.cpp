// SPDX-License-Identifier: MIT
#include "core/lsystem/lsystem.hpp"

#include <algorithm>

namespace phytobench {

namespace {

bool uses_random(const Production& production) {
  if (production.condition && production.condition->uses_random()) return true;
  return std::any_of(
      production.successor.begin(), production.successor.end(), [](const SuccessorModule& module) {
        return std::any_of(module.parameters.begin(), module.parameters.end(),
                           [](const Expression& parameter) { return parameter.uses_random(); });
      });
}

}  // namespace

LSystemKind kind_of(const LSystem& system) {
  LSystemKind kind;
  for (const Symbol& symbol : system.symbols) {
    kind.parametric = kind.parametric || symbol.arity > 0;
    kind.queries = kind.queries || symbol.letter.starts_with('?');
  }
  for (const Production& production : system.productions) {
    // A probability of 1 chooses nothing.
    const bool chooses = production.probability.value_or(1.0) < 1.0;
    kind.stochastic_choice = kind.stochastic_choice || chooses;
    kind.stochastic = kind.stochastic || chooses || uses_random(production);
    kind.conditional = kind.conditional || production.condition.has_value();
    kind.contextual = kind.contextual || !production.left.empty() || !production.right.empty();
  }
  return kind;
}

std::optional<SymbolIndex> find_symbol(const LSystem& system, std::string_view letter,
                                       std::size_t arity) {
  for (std::size_t i = 0; i < system.symbols.size(); ++i)
    if (system.symbols[i].arity == arity && system.symbols[i].letter == letter)
      return static_cast<SymbolIndex>(i);
  return std::nullopt;
}

}  // namespace phytobench
