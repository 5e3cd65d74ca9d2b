// SPDX-License-Identifier: MIT
#include "core/lsystem/composed_successors.hpp"

#include <algorithm>
#include <span>

namespace phytobench {

namespace {

using Successors = std::vector<std::vector<SymbolIndex>>;

/// A quarter of a second-level cache or less.
constexpr std::size_t most_bytes = std::size_t{1} << 17;
/// Enough for everything that grows faster than linearly.
constexpr int most_composed = 64;

std::span<const SymbolIndex> run_of(const SymbolRun& run) {
  return {run.first, run.count};
}

std::size_t composed_bytes(const ProductionTable& table, const Successors& successors) {
  std::size_t bytes = 0;
  for (std::size_t s = 0; s < successors.size(); ++s)
    for (const SymbolIndex part : run_of(table.symbol_runs()[s])) {
      bytes += successors[part].size();
      if (bytes > most_bytes) return bytes;
    }
  return bytes;
}

/// One step, and then those of `successors`.
Successors composed(const ProductionTable& table, const Successors& successors) {
  Successors longer(successors.size());
  for (std::size_t s = 0; s < successors.size(); ++s)
    for (const SymbolIndex part : run_of(table.symbol_runs()[s]))
      longer[s].insert(longer[s].end(), successors[part].begin(), successors[part].end());
  return longer;
}

}  // namespace

ComposedSuccessors::ComposedSuccessors(const ProductionTable& table, std::size_t symbol_count,
                                       int most_steps) {
  Successors successors;
  for (std::size_t s = 0; s < symbol_count; ++s) {
    const auto run = run_of(table.symbol_runs()[s]);
    successors.emplace_back(run.begin(), run.end());
  }
  while (steps_ < std::min(most_steps, most_composed) &&
         composed_bytes(table, successors) <= most_bytes) {
    successors = composed(table, successors);
    ++steps_;
  }
  for (const auto& successor : successors)
    pool_.insert(pool_.end(), successor.begin(), successor.end());
  pool_.insert(pool_.end(), SymbolRun::readable, SymbolIndex{0});
  const SymbolIndex* first = pool_.data();
  for (const auto& successor : successors) {
    runs_.push_back({first, static_cast<std::uint32_t>(successor.size())});
    first += successor.size();
    longest_ = std::max(longest_, successor.size());
  }
}

}  // namespace phytobench
