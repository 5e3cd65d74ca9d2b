// SPDX-License-Identifier: MIT
#include "core/lsystem/composed_successors.hpp"

#include <algorithm>
#include <span>

namespace phytobench {

namespace {

using Successors = std::vector<std::vector<SymbolIndex>>;

/// A quarter of a second-level cache or less.
constexpr std::size_t most_bytes = std::size_t{1} << 17;

std::span<const SymbolIndex> run_of(const SymbolRun& run) {
  return {run.first, run.count};
}

std::size_t composed_bytes(const Successors& first, const Successors& then) {
  std::size_t bytes = 0;
  for (const auto& successor : first)
    for (const SymbolIndex part : successor) {
      bytes += then[part].size();
      if (bytes > most_bytes) return bytes;
    }
  return bytes;
}

Successors composed(const Successors& first, const Successors& then) {
  Successors longer(first.size());
  for (std::size_t s = 0; s < first.size(); ++s)
    for (const SymbolIndex part : first[s])
      longer[s].insert(longer[s].end(), then[part].begin(), then[part].end());
  return longer;
}

}  // namespace

ComposedSuccessors::ComposedSuccessors(const ProductionTable& table, std::size_t symbol_count,
                                       int most_steps) {
  Successors single;
  for (std::size_t s = 0; s < symbol_count; ++s) {
    const auto run = run_of(table.symbol_runs()[s]);
    single.emplace_back(run.begin(), run.end());
  }
  Successors successors = single;
  while (steps_ < std::min(most_steps, most_counted) &&
         composed_bytes(single, successors) <= most_bytes) {
    successors = composed(single, successors);
    ++steps_;
  }
  while (steps_ >= most_counted && steps_ <= most_steps / 2 &&
         composed_bytes(successors, successors) <= most_bytes) {
    successors = composed(successors, successors);
    steps_ *= 2;
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
