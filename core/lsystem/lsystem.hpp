// SPDX-License-Identifier: MIT
// What an L-system is made of. Everything here is plain data; read_lsystem.hpp makes it from text
// and guarantees what the comments promise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/lsystem/expression.hpp"
#include "core/lsystem/turtle_settings.hpp"

namespace phytobench {

/// Index into LSystem::symbols. A letter with one number of parameters and the same letter with
/// another are two symbols: productions match both ([Liebemann2017] sec. 2.2.1).
using SymbolIndex = std::uint8_t;
inline constexpr std::size_t most_symbols = 256;

struct Symbol {
  std::string letter;  ///< "F", "?P"; longer ones are declared by `alphabet:`
  std::uint8_t arity = 0;
};

/// Where something stands in the text, both from 1; line 0: nowhere.
struct TextPlace {
  int line = 0;
  int column = 0;
};

/// A module in a context: its symbol, and where its parameters come in the production's list of
/// parameters.
struct PatternModule {
  SymbolIndex symbol = 0;
  std::uint16_t first_parameter = 0;
};

/// A module of a successor.
struct SuccessorModule {
  SymbolIndex symbol = 0;
  std::vector<Expression> parameters;  ///< as many as the symbol's arity
};

/// id : left < predecessor > right : condition -> successor : probability
struct Production {
  std::string label;                 ///< "p1"; given by position if the text has none
  std::vector<PatternModule> left;   ///< nearest last; brackets are not allowed
  PatternModule predecessor;         ///< its parameters come after those of `left`
  std::vector<PatternModule> right;  ///< nearest first; brackets stand for branches
  std::optional<Expression> condition;
  std::vector<SuccessorModule> successor;  ///< brackets balanced; may be empty
  /// Productions of equal predecessor, contexts and condition that give one form a group of which
  /// one is drawn; the probabilities of a group add up to 1.
  std::optional<double> probability;
  std::uint16_t group = 0;  ///< productions of a group have the same number, others their own
  std::uint16_t parameter_count = 0;  ///< of left, predecessor and right together
  TextPlace place;                    ///< of the predecessor
};

inline bool has_context(const Production& production) {
  return !production.left.empty() || !production.right.empty();
}

/// A module of the axiom.
struct AxiomModule {
  SymbolIndex symbol = 0;
  std::vector<double> parameters;
};

/// An L-system with everything that is needed to derive and to draw it.
struct LSystem {
  std::string source;  ///< file name, for messages
  std::vector<Symbol> symbols;
  std::vector<AxiomModule> axiom;  ///< not empty, brackets balanced
  std::vector<Production> productions;
  std::vector<bool> ignored;  ///< per symbol: not seen by contexts
  int steps = 1;              ///< derivations unless the user asks for another number
  std::uint64_t seed = 0;     ///< of the random choices, the same
  TurtleSettings turtle;
};

/// What a system's productions ask for; decides which derivation is possible.
struct LSystemKind {
  bool parametric = false;   ///< some symbol has parameters
  bool stochastic = false;   ///< probabilities, or random() in an expression
  bool conditional = false;  ///< conditions
  bool contextual = false;   ///< contexts
  bool queries = false;      ///< query symbols ?P ?H ?U ?L occur

  /// Deterministic, free of context and of parameters: what a D0L-system is.
  bool is_d0l() const {
    return !parametric && !stochastic && !conditional && !contextual && !queries;
  }
  /// The successor of a symbol never depends on anything else than the symbol.
  bool has_fixed_successors() const { return !stochastic_choice && !conditional && !contextual; }
  bool stochastic_choice = false;  ///< probabilities
};

LSystemKind kind_of(const LSystem& system);

/// The symbol of that letter and number of parameters, if there is one.
std::optional<SymbolIndex> find_symbol(const LSystem& system, std::string_view letter,
                                       std::size_t arity);

}  // namespace phytobench
