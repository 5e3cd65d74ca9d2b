// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace phytobench {

namespace detail {

/// A call without std::function, which may allocate.
using RangeCall = void (*)(const void* body, std::size_t begin, std::size_t end);
void run_in_blocks(std::size_t count, std::size_t block_size, int threads, const void* body,
                   RangeCall call);

template <class Body>
void call_body(const void* body, std::size_t begin, std::size_t end) {
  (*static_cast<const Body*>(body))(begin, end);
}

void run_alone(const void* body, void (*call)(const void* body));

}  // namespace detail

/// Runs body(begin, end) over [0, count) in blocks of fixed size on up to `threads` threads. The
/// blocks do not depend on the thread count; whoever writes per element and adds only integers gets
/// the same bits for any number of threads. With one thread it is a plain call over the whole
/// range. Allocates nothing then.
template <class Body>
void for_blocks(std::size_t count, int threads, const Body& body) {
  constexpr std::size_t block_size = 512;
  detail::run_in_blocks(count, block_size, threads, &body, detail::call_body<Body>);
}

/// Runs body() such that a library that shares out its work on oneTBB by itself keeps to one
/// thread: what it builds is then the same on every machine.
template <class Body>
void on_one_thread(const Body& body) {
  detail::run_alone(&body, [](const void* b) { (*static_cast<const Body*>(b))(); });
}

/// Runs body(0) ... body(count - 1), each once, on up to `threads` threads; in ascending order with
/// one. For few pieces of unequal size.
template <class Body>
void for_tasks(std::size_t count, int threads, const Body& body) {
  const auto pieces = [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  };
  detail::run_in_blocks(count, 1, threads, &pieces, detail::call_body<decltype(pieces)>);
}

}  // namespace phytobench
