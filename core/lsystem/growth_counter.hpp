// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// Counts the symbols of a system with fixed successors step by step, with the matrix of how often
/// each occurs in the successor of each. 2^64 - 1 stands for that many or more.
class GrowthCounter {
 public:
  static constexpr std::uint64_t most = ~std::uint64_t{0};

  /// Begins with the axiom. Of several productions of a symbol the first with a chance counts.
  explicit GrowthCounter(const LSystem& system);
  void advance();  ///< by one step

  const std::vector<std::uint64_t>& symbols() const { return counts_; }
  std::uint64_t modules() const;
  std::uint64_t parameters() const;
  bool saturated() const;  ///< some number is `most`

 private:
  struct Part {
    SymbolIndex symbol;
    std::uint64_t count;
  };
  std::vector<std::uint8_t> arities_;
  std::vector<std::vector<Part>> successors_;  // per symbol
  std::vector<std::uint64_t> counts_, next_;
};

}  // namespace phytobench
