// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// A whole number of any size.
struct ExactCount {
  std::string digits = "0";
  std::optional<std::uint64_t> number = 0;  ///< unless it is greater than 2^64 - 1
};

/// What the matrix of a system whose successors are fixed says of the word after so many steps.
struct PredictedSymbols {
  std::vector<ExactCount> symbols;     ///< of each symbol of the system
  ExactCount modules;                  ///< all of them
  std::optional<ExactCount> segments;  ///< that are drawn; absent if % may cut some off
};

/// Counts by an oracle that shares no code with derive() and makes no word: of core, only the
/// productions are read. Nothing for systems whose successors depend on chance, conditions or
/// contexts, and where the numbers would be so long that counting takes more than some seconds.
std::optional<PredictedSymbols> predicted_symbols(const LSystem& system, int steps);

/// What numbers of symbols that were made have against the prediction, in one line; empty if
/// nothing.
std::string symbol_count_disagreement(const LSystem& system, std::span<const std::uint64_t> made,
                                      const PredictedSymbols& predicted);

/// The same for the number of segments drawn.
std::string segment_count_disagreement(std::uint64_t drawn, const PredictedSymbols& predicted);

/// "F", and "A(.,.)" with two parameters.
std::string name_of(const Symbol& symbol);

}  // namespace phytobench
