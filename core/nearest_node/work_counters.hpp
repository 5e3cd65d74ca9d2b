// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/contract/work_counting.hpp"

namespace phytobench {

/// Work done since reset(), independent of the machine. Sums of integers, so the order of threads
/// does not matter.
struct WorkCounters {
  std::uint64_t search_evaluations = 0;  ///< squared distances computed to find nearest nodes
  std::uint64_t kill_evaluations = 0;    ///< squared distances computed to remove points
  std::uint64_t cells_visited = 0;       ///< grid cells or sorted windows looked into
  std::uint64_t index_updates = 0;       ///< nodes entered into the engine's index (moves included)
  std::uint64_t queries = 0;             ///< points for which a nearest node was searched
  std::uint64_t angle_tests = 0;         ///< perception angle tests; only with counts_inner_loop

  friend bool operator==(const WorkCounters&, const WorkCounters&) = default;

  WorkCounters& operator+=(const WorkCounters& other) {
    search_evaluations += other.search_evaluations;
    kill_evaluations += other.kill_evaluations;
    cells_visited += other.cells_visited;
    index_updates += other.index_updates;
    queries += other.queries;
    angle_tests += other.angle_tests;
    return *this;
  }
};

}  // namespace phytobench
