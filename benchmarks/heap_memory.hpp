// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace phytobench {

/// Bytes that are allocated and not yet freed, in all arenas and in blocks of their own. Nothing
/// where the C library cannot tell (another allocator, a sanitizer).
std::optional<std::int64_t> heap_bytes();

}  // namespace phytobench
