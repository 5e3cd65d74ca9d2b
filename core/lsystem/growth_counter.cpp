// SPDX-License-Identifier: MIT
#include "core/lsystem/growth_counter.hpp"

#include <algorithm>
#include <array>

namespace phytobench {

namespace {

std::uint64_t sum_up_to_most(std::uint64_t a, std::uint64_t b) {
  return a > GrowthCounter::most - b ? GrowthCounter::most : a + b;
}

std::uint64_t product_up_to_most(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > GrowthCounter::most / b ? GrowthCounter::most : a * b;
}

}  // namespace

GrowthCounter::GrowthCounter(const LSystem& system)
    : successors_(system.symbols.size()),
      counts_(system.symbols.size(), 0),
      next_(system.symbols.size(), 0) {
  for (std::size_t s = 0; s < system.symbols.size(); ++s) {
    arities_.push_back(system.symbols[s].arity);
    successors_[s] = {{static_cast<SymbolIndex>(s), 1}};
  }
  std::vector<bool> replaced(system.symbols.size(), false);
  for (const Production& production : system.productions) {
    const SymbolIndex from = production.predecessor.symbol;
    if (replaced[from] || production.probability.value_or(1.0) <= 0.0) continue;
    replaced[from] = true;
    std::array<std::uint64_t, most_symbols> counts{};
    for (const SuccessorModule& module : production.successor) ++counts[module.symbol];
    successors_[from].clear();
    for (std::size_t s = 0; s < most_symbols; ++s)
      if (counts[s] > 0) successors_[from].push_back({static_cast<SymbolIndex>(s), counts[s]});
  }
  for (const AxiomModule& module : system.axiom) ++counts_[module.symbol];
}

void GrowthCounter::advance() {
  std::fill(next_.begin(), next_.end(), std::uint64_t{0});
  for (std::size_t s = 0; s < counts_.size(); ++s) {
    if (counts_[s] == 0) continue;
    for (const Part& part : successors_[s])
      next_[part.symbol] =
          sum_up_to_most(next_[part.symbol], product_up_to_most(counts_[s], part.count));
  }
  counts_.swap(next_);
}

std::uint64_t GrowthCounter::modules() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts_) sum = sum_up_to_most(sum, count);
  return sum;
}

std::uint64_t GrowthCounter::parameters() const {
  std::uint64_t sum = 0;
  for (std::size_t s = 0; s < counts_.size(); ++s)
    sum = sum_up_to_most(sum, product_up_to_most(counts_[s], arities_[s]));
  return sum;
}

bool GrowthCounter::saturated() const {
  return modules() == most || parameters() == most;
}

}  // namespace phytobench
