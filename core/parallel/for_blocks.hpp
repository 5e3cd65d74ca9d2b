// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace phytobench {

/// Runs body(begin, end) over [0, count) in blocks of fixed size on up to `threads` threads. The
/// blocks do not depend on the thread count; whoever writes per element and adds only integers gets
/// the same bits for any number of threads. With one thread it is a plain call over the whole
/// range.
void for_blocks(std::size_t count, int threads,
                const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs body(0) ... body(count - 1), each once, on up to `threads` threads; in ascending order with
/// one. For few pieces of unequal size.
void for_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace phytobench
