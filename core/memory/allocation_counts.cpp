// SPDX-License-Identifier: MIT
#include "core/memory/allocation_counts.hpp"

#include "counting_policy.hpp"

#if PHYTOBENCH_COUNTS_WORK
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> count{0}, bytes{0};

void* counted(std::size_t size, std::size_t alignment) {
  phytobench::note_allocation(size);
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* memory = alignment <= alignof(std::max_align_t)
                     ? std::malloc(size == 0 ? 1 : size)
                     : std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The standard library's other forms call these.
void* operator new(std::size_t size) {
  return counted(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
#endif

namespace phytobench {

#if PHYTOBENCH_COUNTS_WORK
AllocationCounts allocations_so_far() {
  return {count.load(), bytes.load()};
}

void note_allocation(std::uint64_t size) {
  ++count;
  bytes += size;
}
#else
AllocationCounts allocations_so_far() {
  return {};
}

void note_allocation(std::uint64_t) {}
#endif

}  // namespace phytobench
