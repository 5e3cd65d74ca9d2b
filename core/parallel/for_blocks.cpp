// SPDX-License-Identifier: MIT
#include "core/parallel/for_blocks.hpp"

#include <map>
#include <memory>
#include <mutex>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace phytobench::detail {

namespace {

/// More threads than processors: oneTBB would say on the terminal that it ignores the rest. Call it
/// under a lock.
void allow_at_least(int threads) {
  constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;
  static auto& limit = *new std::unique_ptr<tbb::global_control>;
  const auto wanted = static_cast<std::size_t>(threads);
  if (wanted <= tbb::global_control::active_value(parallelism)) return;
  limit.reset();
  limit = std::make_unique<tbb::global_control>(parallelism, wanted);
}

/// One for each number of threads, for the life of the program: new ones with every call pile up in
/// the library, and each call takes longer than the one before.
tbb::task_arena& arena_of(int threads) {
  static std::mutex guard;
  static auto& arenas = *new std::map<int, tbb::task_arena>;  // never taken down before its users
  const std::lock_guard lock(guard);
  allow_at_least(threads);
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
