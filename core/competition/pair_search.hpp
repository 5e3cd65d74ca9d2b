// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// Finds overlapping zones with one engine and keeps its memory from step to step.
class PairSearch {
 public:
  /// ContractViolation for an engine that is not built.
  PairSearch(const OverlapEngineDescriptor& engine, OverlapSetup setup);

  int threads() const { return setup_.threads; }

  /// Valid until the next call.
  const OverlapPairs& find(const Discs& discs, const Ground& ground);

  /// The same pairs in the same order, some after the other: takes a fraction of the memory.
  void for_each_part(const Discs& discs, const Ground& ground, const TakePairs& take);

  /// For rules that search discs of their own making: `count` more of the plants' own pairs.
  const OverlapPairs& find_uncounted(const Discs& discs, const Ground& ground);
  void count_pairs(std::uint64_t count) { pairs_found_ += count; }

  std::uint64_t pairs_found() const { return pairs_found_; }  ///< over all calls
  std::uint64_t candidates() const { return candidates_; }    ///< the same

 private:
  std::unique_ptr<OverlapEngine> engine_;
  OverlapSetup setup_;
  OverlapPairs pairs_;
  std::uint64_t pairs_found_ = 0;
  std::uint64_t candidates_ = 0;
};

}  // namespace phytobench
