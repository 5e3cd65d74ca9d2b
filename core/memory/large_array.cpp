// SPDX-License-Identifier: MIT
#include "core/memory/large_array.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

#include "core/memory/allocation_counts.hpp"

namespace phytobench {

void* allocate_large(std::size_t bytes) {
  constexpr std::size_t cache_line = 64;
  constexpr std::size_t huge_page = std::size_t{1} << 21;
  const bool huge = bytes >= 2 * huge_page;
  const std::size_t alignment = huge ? huge_page : cache_line;
  const std::size_t whole = (bytes / alignment + 1) * alignment;
  if (whole < bytes) throw std::bad_alloc();
  void* const memory = std::aligned_alloc(alignment, whole);
  if (memory == nullptr) throw std::bad_alloc();
  note_allocation(bytes);
  if (huge) ::madvise(memory, whole, MADV_HUGEPAGE);  // advice: failing is no harm
  return memory;
}

}  // namespace phytobench
