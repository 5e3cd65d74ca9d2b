// SPDX-License-Identifier: MIT
#include "core/lsystem/symbol_histogram.hpp"

#include <algorithm>

namespace phytobench {

namespace {

/// Few enough for counters of 32 bits, which fill half the cache.
constexpr std::size_t most_at_once = std::size_t{1} << 30;

void add_piece(std::span<const SymbolIndex> symbols, SymbolHistogram& sums) {
  // Four sets of counters: a run of one symbol does not wait for its own last increment.
  std::array<std::array<std::uint32_t, most_symbols>, 4> counts{};
  std::size_t i = 0;
  for (; i + 4 <= symbols.size(); i += 4) {
    ++counts[0][symbols[i]];
    ++counts[1][symbols[i + 1]];
    ++counts[2][symbols[i + 2]];
    ++counts[3][symbols[i + 3]];
  }
  for (; i < symbols.size(); ++i) ++counts[0][symbols[i]];
  for (std::size_t s = 0; s < most_symbols; ++s)
    sums[s] += std::uint64_t{counts[0][s]} + counts[1][s] + counts[2][s] + counts[3][s];
}

}  // namespace

SymbolHistogram histogram_of(std::span<const SymbolIndex> symbols) {
  SymbolHistogram sums{};
  for (std::size_t first = 0; first < symbols.size(); first += most_at_once)
    add_piece(symbols.subspan(first, std::min(most_at_once, symbols.size() - first)), sums);
  return sums;
}

}  // namespace phytobench
