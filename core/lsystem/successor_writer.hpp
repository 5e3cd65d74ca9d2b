// SPDX-License-Identifier: MIT
// The loops that write a word: the symbols of successors one after the other, and their parameters.
#pragma once

#include <cstdint>
#include <span>

#include "core/lsystem/production_table.hpp"

namespace phytobench {

/// Writes the symbols of runs[outcomes[0]], runs[outcomes[1]], ... to out; together they fill it
/// exactly. OutcomeIndex, or SymbolIndex where nothing is chosen and symbols stand for outcomes.
template <class Index>
void write_symbols(std::span<const Index> outcomes, const SymbolRun* runs,
                   std::span<SymbolIndex> out);

/// What successors take their parameters from.
struct ParameterSource {
  const ProductionTable* table = nullptr;
  const ContextMatch* contexts = nullptr;  ///< only where successors see contexts
  double* gathered = nullptr;              ///< the same: room for table->most_parameters() numbers
  std::uint64_t seed = 0;
  int step = 0;
};

/// Writes the parameters of the successors of consecutive modules, from the one at `position` of
/// the old word on, whose own parameters begin at `in`. in[0] must be there and finite even if none
/// of the modules has parameters.
template <class Index>
void write_parameters(const ParameterSource& source, std::span<const Index> outcomes,
                      std::size_t position, const double* in, std::span<double> out);

/// Whether no number is infinite or no number at all.
bool all_finite(std::span<const double> numbers);

}  // namespace phytobench
