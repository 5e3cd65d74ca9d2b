// SPDX-License-Identifier: MIT
#include "core/memory/keep_freed_memory.hpp"

#include <malloc.h>

#include <limits>

namespace phytobench {

void keep_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_MAX, 0);  // pieces of their own would be unmapped when freed
  ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  ::mallopt(M_TOP_PAD, 1 << 26);
#endif
}

}  // namespace phytobench
