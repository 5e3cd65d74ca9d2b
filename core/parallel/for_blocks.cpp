// SPDX-License-Identifier: MIT
#include "core/parallel/for_blocks.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace phytobench::detail {

void run_in_blocks(std::size_t count, std::size_t block_size, int threads, const void* body,
                   RangeCall call) {
  if (threads <= 1 || count <= block_size) {
    call(body, 0, count);
    return;
  }
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, block_size),
        [&](const tbb::blocked_range<std::size_t>& range) {
          call(body, range.begin(), range.end());
        },
        tbb::simple_partitioner());
  });
}

}  // namespace phytobench::detail
