// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/contract/work_counting.hpp"
#include "core/lsystem/production_table.hpp"

namespace phytobench {

/// A module of the old word.
struct ModuleSite {
  std::size_t position = 0;
  SymbolIndex symbol = 0;
  const double* parameters = nullptr;  ///< its own; the first must be readable and finite
};

/// Which production replaces a module in one step. For one thread.
class ProductionChoice {
 public:
  /// `contexts` may be null if no production has contexts.
  ProductionChoice(const ProductionTable& table, const ContextMatch* contexts, std::uint64_t seed,
                   int step)
      : table_(&table), contexts_(contexts), seed_(seed), step_(step) {}

  /// The outcome of a module, or no_outcome if a condition has no finite value; that production is
  /// handed over in `unfit` then. `gathered` has room for table.most_parameters() numbers.
  OutcomeIndex outcome_of(const ModuleSite& site, double* gathered, const Production*& unfit);

  /// Over all calls; 0 unless counts_inner_loop.
  std::uint64_t productions_tried() const { return tried_.count(); }

 private:
  OutcomeIndex drawn(const Candidate& candidate, std::size_t position) const;

  const ProductionTable* table_;
  const ContextMatch* contexts_;
  std::uint64_t seed_;
  int step_;
  InnerLoopCounter tried_;
};

}  // namespace phytobench
