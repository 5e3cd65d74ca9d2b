// SPDX-License-Identifier: MIT
// For engines that follow rays: rows of a map shared out among threads, and what they counted.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "core/parallel/for_blocks.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

/// Runs trace(row, work) for every row; the work of all is added up.
template <class Trace>
ShadowWork trace_rows(int rows, int threads, const Trace& trace) {
  constexpr int rows_in_task = 8;
  std::atomic<std::uint64_t> samples{0}, blocks{0}, rays{0}, stuck{0};
  const auto tasks = static_cast<std::size_t>((rows + rows_in_task - 1) / rows_in_task);
  for_tasks(tasks, threads, [&](std::size_t task) {
    const int first = static_cast<int>(task) * rows_in_task;
    ShadowWork work;
    for (int row = first; row < std::min(first + rows_in_task, rows); ++row) trace(row, work);
    samples += work.samples;
    blocks += work.blocks;
    rays += work.rays;
    stuck += work.stuck;
  });
  return {samples, blocks, rays, stuck};
}

}  // namespace phytobench
