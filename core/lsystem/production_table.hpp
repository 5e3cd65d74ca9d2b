// SPDX-License-Identifier: MIT
// An L-system's productions, made ready for the loops over a word.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/lsystem/compiled_expression.hpp"
#include "core/lsystem/context_match.hpp"
#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// What becomes of a module. Below most_symbols: what that symbol always becomes; of symbols that
/// have a choice, the module itself. From most_symbols on: the successor of production
/// (outcome - most_symbols).
using OutcomeIndex = std::uint16_t;
inline constexpr OutcomeIndex no_outcome = std::numeric_limits<OutcomeIndex>::max();

/// The symbols of a successor. `readable` bytes from `first` may be read whatever `count` says.
struct SymbolRun {
  static constexpr std::size_t readable = 32;
  const SymbolIndex* first = nullptr;
  std::uint32_t count = 0;
};

/// The parameters of a successor.
struct ParameterRun {
  enum class Work : std::uint8_t {
    linear,     ///< of LinearParameters of the module's own parameters
    general,    ///< CompiledExpressions of the module's own parameters
    contextual  ///< CompiledExpressions of all parameters of the production
  };
  std::uint32_t first = 0;  ///< in linear_parameters() or expressions()
  std::uint32_t count = 0;
  std::uint8_t consumed = 0;  ///< parameters of the module that is replaced
  Work work = Work::linear;
};

/// One of the successors that a candidate draws from.
struct Alternative {
  double below = 1.0;  ///< taken if the number drawn is below this and not below the one before
  OutcomeIndex outcome = no_outcome;
};

/// Productions that fit together or not at all: one, or a group with probabilities.
struct Candidate {
  const Production* production = nullptr;   ///< the first of them
  const ContextPattern* pattern = nullptr;  ///< null: no context
  std::optional<CompiledExpression> condition;
  bool condition_sees_contexts = false;  ///< else it takes the module's own parameters
  std::vector<Alternative> alternatives;
};

class ProductionTable {
 public:
  /// Keeps pointers into the system. Throws InputError if it has more productions than
  /// OutcomeIndex can tell apart, or contexts nested too deep.
  explicit ProductionTable(const LSystem& system);
  ProductionTable(const ProductionTable&) = delete;
  ProductionTable& operator=(const ProductionTable&) = delete;

  /// The successor of a module depends on nothing but its symbol.
  bool is_fixed() const { return !has_choices_; }
  bool is_parametric() const { return parametric_; }
  bool is_contextual() const { return contextual_; }
  bool has_choice(SymbolIndex symbol) const { return choices_[symbol]; }
  /// Those of a symbol with a choice, in the order in which they are tried.
  std::span<const Candidate> candidates(SymbolIndex symbol) const { return candidates_[symbol]; }

  /// Per outcome.
  const SymbolRun* symbol_runs() const { return symbol_runs_.data(); }
  const ParameterRun* parameter_runs() const { return parameter_runs_.data(); }
  const LinearParameter* linear_parameters() const { return linear_parameters_.data(); }
  const CompiledExpression* expressions() const { return expressions_.data(); }
  /// The production behind an outcome; null if the module stays as it is.
  const Production* production_of(OutcomeIndex outcome) const { return productions_[outcome]; }
  const ContextPattern& pattern_of(OutcomeIndex outcome) const {
    return patterns_[outcome - most_symbols];
  }
  std::uint8_t arity(SymbolIndex symbol) const { return arities_[symbol]; }
  /// Of left, predecessor and right together, over all productions.
  std::size_t most_parameters() const { return most_parameters_; }

 private:
  void add_identities(const LSystem& system);
  void add_production(const LSystem& system, const Production& production);
  void add_parameters(const Production& production, std::uint8_t arity);
  void add_candidates(const LSystem& system, SymbolIndex symbol);
  void settle_fixed_successors(const LSystem& system);
  Candidate candidate_of(const LSystem& system, std::size_t first) const;

  bool has_choices_ = false, parametric_ = false, contextual_ = false;
  std::array<bool, most_symbols> choices_{};
  std::array<std::uint8_t, most_symbols> arities_{};
  std::size_t most_parameters_ = 0;
  std::vector<SymbolIndex> pool_;             // all symbol runs
  std::vector<std::size_t> run_begins_;       // in pool_, per outcome
  std::vector<SymbolRun> symbol_runs_;        // per outcome
  std::vector<ParameterRun> parameter_runs_;  // per outcome
  std::vector<LinearParameter> linear_parameters_;
  std::vector<CompiledExpression> expressions_;
  std::vector<const Production*> productions_;  // per outcome
  std::vector<ContextPattern> patterns_;        // per production
  std::array<std::vector<Candidate>, most_symbols> candidates_;
};

}  // namespace phytobench
