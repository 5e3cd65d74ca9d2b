// SPDX-License-Identifier: MIT
// The innermost loops of the layered grid, vectorised by Highway and chosen for the processor at
// run time. Every target gives the same pairs in the same order, and the same bits.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/overlap/layered_grid/layered_grid.hpp"
#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

struct PairScanJob {
  const LayeredGrid* grid = nullptr;
  std::size_t layer = 0;
  std::int32_t first_row = 0;  ///< of the layer: discs of these rows are scanned
  std::int32_t end_row = 0;
  std::size_t most_pairs = 0;
  std::atomic<std::size_t>* pairs_so_far = nullptr;  ///< of all jobs
};

/// For every disc of the job its partners that come after it in its own layer and all those in
/// layers of smaller discs, so that over all jobs every pair (and image of it) is found once. Adds
/// them to `pairs`. Throws InputError beyond most_pairs.
OverlapWork scan_pairs(const PairScanJob& job, OverlapPairs& pairs);

}  // namespace phytobench
