// SPDX-License-Identifier: MIT
// Finds again what went wrong in a block, for the message: the fast loops only note that something
// did.
#include <algorithm>

#include "core/contract/check.hpp"
#include "core/lsystem/derivation.hpp"
#include "core/lsystem/module_text.hpp"

namespace phytobench {

namespace {

/// The module of the successor that holds the first number that is not finite.
std::string module_with_fault(const LSystem& system, const Production& production,
                              std::span<const double> parameters) {
  const double* from = parameters.data();
  for (const SuccessorModule& module : production.successor) {
    const Symbol& symbol = system.symbols[module.symbol];
    if (!all_finite({from, symbol.arity})) return module_text(symbol, from);
    from += symbol.arity;
  }
  return {};
}

}  // namespace

void Derivation::refuse_faults(int step, std::size_t first, std::size_t count) const {
  for (std::size_t b = first; b < first + count; ++b) {
    if (blocks_[b].unfit != nullptr) refuse_condition_of(blocks_[b], step);
    if (blocks_[b].faulty) refuse_parameters_of(blocks_[b], step);
  }
}

void Derivation::refuse_condition_of(const Block& block, int step) const {
  const double* parameters = now_.word.parameters.data() + block.parameters_from;
  for (std::size_t i = block.first; i < block.unfit_at; ++i)
    parameters += table_.arity(now_.word.symbols[i]);
  refuse_condition(system_, *block.unfit, place(step, block.unfit_at, parameters));
}

void Derivation::refuse_parameters_of(const Block& block, int step) const {
  std::vector<double> gathered, made;
  const ParameterSource from = source(step, gathered);
  const double* parameters = now_.word.parameters.data() + block.parameters_from;
  for (std::size_t i = block.first; i < block.first + block.count; ++i) {
    const SymbolIndex symbol = now_.word.symbols[i];
    const OutcomeIndex outcome = table_.is_fixed() ? OutcomeIndex{symbol} : outcomes_[i];
    made.assign(table_.parameter_runs()[outcome].count, 0.0);
    write_parameters<OutcomeIndex>(from, {&outcome, 1}, i, parameters, made);
    if (!all_finite(made)) {
      const Production* const production = table_.production_of(outcome);
      PHYTOBENCH_ENSURE(production != nullptr);
      refuse_parameter(system_, *production, place(step, i, parameters),
                       module_with_fault(system_, *production, made));
    }
    parameters += table_.arity(symbol);
  }
  contract_failed("promise", "a faulty block has a fault", __FILE__, __LINE__);
}

DerivationPlace Derivation::place(int step, std::size_t position, const double* parameters) const {
  DerivationPlace place;
  place.step = step;
  place.position = position;
  place.module = module_text(system_.symbols[now_.word.symbols[position]], parameters);
  return place;
}

}  // namespace phytobench
