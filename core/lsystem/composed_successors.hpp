// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/lsystem/production_table.hpp"

namespace phytobench {

/// What each symbol becomes in several steps at once. A word derived with it is mostly long copies,
/// and the words between are never made. Only for fixed successors without parameters.
class ComposedSuccessors {
 public:
  /// Enough for everything that grows faster than linearly. What grows no faster needs many more:
  /// a word that takes n steps would be copied about n / most_counted times.
  static constexpr int most_counted = 64;

  /// As many steps as fit into a table that stays near the processor, at least one and at most
  /// `most_steps`. More than most_counted of them are most_counted times a power of 2.
  ComposedSuccessors(const ProductionTable& table, std::size_t symbol_count, int most_steps);

  int steps() const { return steps_; }
  const SymbolRun* runs() const { return runs_.data(); }  ///< per symbol
  std::size_t longest() const { return longest_; }        ///< of the runs

 private:
  int steps_ = 1;
  std::size_t longest_ = 0;
  std::vector<SymbolIndex> pool_;
  std::vector<SymbolRun> runs_;
};

}  // namespace phytobench
