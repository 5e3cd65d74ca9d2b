// SPDX-License-Identifier: MIT
#include "core/lsystem/production_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

OutcomeIndex outcome_of(std::size_t production) {
  return static_cast<OutcomeIndex>(most_symbols + production);
}

/// The production alone, or the group that begins with it, without members that have no chance.
std::vector<Alternative> alternatives_of(const LSystem& system, std::size_t first) {
  const Production& production = system.productions[first];
  if (!production.probability) return {{1.0, outcome_of(first)}};
  std::vector<Alternative> alternatives;
  double below = 0.0;
  for (std::size_t k = first; k < system.productions.size(); ++k) {
    const Production& member = system.productions[k];
    const double probability = member.probability.value_or(0.0);
    if (member.group != production.group || probability <= 0.0) continue;
    below += probability;
    alternatives.push_back({below, outcome_of(k)});
  }
  PHYTOBENCH_EXPECT(!alternatives.empty());
  return alternatives;
}

}  // namespace

ProductionTable::ProductionTable(const LSystem& system) {
  constexpr std::size_t most_productions = no_outcome - most_symbols;
  if (system.productions.size() > most_productions)
    throw InputError(fmt::format("{}: {} productions are too many (keep to {})", system.source,
                                 system.productions.size(), most_productions));
  add_identities(system);
  for (const Production& production : system.productions) add_production(system, production);
  pool_.insert(pool_.end(), SymbolRun::readable, SymbolIndex{0});
  for (std::size_t outcome = 0; outcome < symbol_runs_.size(); ++outcome)
    symbol_runs_[outcome].first = pool_.data() + run_begins_[outcome];
  for (std::size_t s = 0; s < system.symbols.size(); ++s)
    add_candidates(system, static_cast<SymbolIndex>(s));
  settle_fixed_successors(system);
}

/// Outcomes below most_symbols: each symbol stays what it is, with its parameters.
void ProductionTable::add_identities(const LSystem& system) {
  for (std::size_t s = 0; s < most_symbols; ++s) {
    const std::uint8_t arity =
        s < system.symbols.size() ? system.symbols[s].arity : std::uint8_t{0};
    arities_[s] = arity;
    parametric_ = parametric_ || arity > 0;
    run_begins_.push_back(pool_.size());
    pool_.push_back(static_cast<SymbolIndex>(s));
    symbol_runs_.push_back({nullptr, 1});
    ParameterRun parameters;
    parameters.first = static_cast<std::uint32_t>(linear_parameters_.size());
    parameters.count = parameters.consumed = arity;
    parameter_runs_.push_back(parameters);
    for (std::size_t i = 0; i < arity; ++i) linear_parameters_.push_back({1.0, -0.0, i});
    productions_.push_back(nullptr);
  }
}

void ProductionTable::add_production(const LSystem& system, const Production& production) {
  run_begins_.push_back(pool_.size());
  for (const SuccessorModule& module : production.successor) pool_.push_back(module.symbol);
  symbol_runs_.push_back({nullptr, static_cast<std::uint32_t>(production.successor.size())});
  add_parameters(production, system.symbols[production.predecessor.symbol].arity);
  productions_.push_back(&production);
  patterns_.push_back(compiled_pattern(system, production));
  contextual_ = contextual_ || has_context(production);
  most_parameters_ = std::max(most_parameters_, std::size_t{production.parameter_count});
}

void ProductionTable::add_parameters(const Production& production, std::uint8_t arity) {
  const std::uint16_t own = production.predecessor.first_parameter;
  bool contextual = false;
  std::vector<const Expression*> parameters;
  for (const SuccessorModule& module : production.successor) {
    for (const Expression& parameter : module.parameters) {
      parameters.push_back(&parameter);
      contextual = contextual || reads_outside(parameter, own, arity);
    }
  }
  std::vector<CompiledExpression> compiled;
  for (const Expression* parameter : parameters)
    compiled.emplace_back(*parameter, contextual ? std::uint16_t{0} : own);
  const bool linear = !contextual && std::all_of(compiled.begin(), compiled.end(),
                                                 [](const auto& e) { return e.linear(); });
  ParameterRun run;
  run.count = static_cast<std::uint32_t>(compiled.size());
  run.consumed = arity;
  run.first = static_cast<std::uint32_t>(linear ? linear_parameters_.size() : expressions_.size());
  if (linear) {
    for (const CompiledExpression& e : compiled) linear_parameters_.push_back(*e.linear());
  } else {
    run.work = contextual ? ParameterRun::Work::contextual : ParameterRun::Work::general;
    expressions_.insert(expressions_.end(), compiled.begin(), compiled.end());
  }
  parameter_runs_.push_back(run);
}

/// Those with contexts first, then as in the text; a group stands where its first member does.
void ProductionTable::add_candidates(const LSystem& system, SymbolIndex symbol) {
  std::vector<Candidate>& candidates = candidates_[symbol];
  for (const bool with_context : {true, false}) {
    std::vector<std::uint16_t> seen;
    for (std::size_t k = 0; k < system.productions.size(); ++k) {
      const Production& production = system.productions[k];
      if (production.predecessor.symbol != symbol || has_context(production) != with_context)
        continue;
      if (std::find(seen.begin(), seen.end(), production.group) != seen.end()) continue;
      if (production.probability) seen.push_back(production.group);
      candidates.push_back(candidate_of(system, k));
    }
  }
}

Candidate ProductionTable::candidate_of(const LSystem& system, std::size_t first) const {
  const Production& production = system.productions[first];
  Candidate candidate;
  candidate.production = &production;
  candidate.alternatives = alternatives_of(system, first);
  if (has_context(production)) candidate.pattern = &patterns_[first];
  if (production.condition) {
    const std::uint16_t own = production.predecessor.first_parameter;
    candidate.condition_sees_contexts =
        reads_outside(*production.condition, own, arities_[production.predecessor.symbol]);
    candidate.condition.emplace(*production.condition,
                                candidate.condition_sees_contexts ? std::uint16_t{0} : own);
  }
  return candidate;
}

/// A symbol whose first candidate always fits has no choice.
void ProductionTable::settle_fixed_successors(const LSystem& system) {
  for (std::size_t s = 0; s < system.symbols.size(); ++s) {
    std::vector<Candidate>& candidates = candidates_[s];
    if (candidates.empty()) continue;
    const Candidate& first = candidates.front();
    if (first.pattern || first.condition || first.alternatives.size() > 1) {
      choices_[s] = has_choices_ = true;
      continue;
    }
    const OutcomeIndex outcome = first.alternatives.front().outcome;
    symbol_runs_[s] = symbol_runs_[outcome];
    parameter_runs_[s] = parameter_runs_[outcome];
    productions_[s] = productions_[outcome];
  }
}

}  // namespace phytobench
