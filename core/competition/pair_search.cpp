// SPDX-License-Identifier: MIT
#include "core/competition/pair_search.hpp"

#include "core/contract/check.hpp"

namespace phytobench {

PairSearch::PairSearch(const OverlapEngineDescriptor& engine, OverlapSetup setup) : setup_(setup) {
  PHYTOBENCH_EXPECT(engine.built());
  engine_ = engine.create();
}

const OverlapPairs& PairSearch::find(const Discs& discs, const Ground& ground) {
  const OverlapPairs& pairs = find_uncounted(discs, ground);
  pairs_found_ += pairs.size();
  return pairs;
}

const OverlapPairs& PairSearch::find_uncounted(const Discs& discs, const Ground& ground) {
  candidates_ += engine_->find(discs, ground, setup_, pairs_).candidates;
  return pairs_;
}

void PairSearch::for_each_part(const Discs& discs, const Ground& ground, const TakePairs& take) {
  const auto count_and_take = [&](std::span<const OverlapPairs> pieces) {
    for (const OverlapPairs& piece : pieces) pairs_found_ += piece.size();
    take(pieces);
  };
  candidates_ += engine_->find_in_parts(discs, ground, setup_, pairs_, count_and_take).candidates;
}

}  // namespace phytobench
