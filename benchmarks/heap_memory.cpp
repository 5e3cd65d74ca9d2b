// SPDX-License-Identifier: MIT
#include "benchmarks/heap_memory.hpp"

#include <malloc.h>

namespace phytobench {

std::optional<std::int64_t> heap_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  const auto bytes = static_cast<std::int64_t>(info.uordblks + info.hblkhd);
  if (bytes == 0) return std::nullopt;  // this program itself holds some
  return bytes;
}

}  // namespace phytobench
