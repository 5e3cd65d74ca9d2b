// SPDX-License-Identifier: MIT
#include "core/parallel/for_blocks.hpp"

#include <map>
#include <mutex>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace phytobench::detail {

namespace {

/// One for each number of threads, for the life of the program: new ones with every call pile up in
/// the library, and each call takes longer than the one before.
tbb::task_arena& arena_of(int threads) {
  static std::mutex guard;
  static auto& arenas = *new std::map<int, tbb::task_arena>;  // never taken down before its users
  const std::lock_guard lock(guard);
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

void run_in_blocks(std::size_t count, std::size_t block_size, int threads, const void* body,
                   RangeCall call) {
  if (threads <= 1 || count <= block_size) {
    call(body, 0, count);
    return;
  }
  arena_of(threads).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, block_size),
        [&](const tbb::blocked_range<std::size_t>& range) {
          call(body, range.begin(), range.end());
        },
        tbb::simple_partitioner());
  });
}

void run_alone(const void* body, void (*call)(const void* body)) {
  arena_of(1).execute([&] { call(body); });
}

}  // namespace phytobench::detail
