// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace phytobench {

/// Memory that the system has given to this program: now, and at most since reset_peak_memory().
/// Nothing where the system does not tell (/proc).
std::optional<std::int64_t> resident_bytes();
std::optional<std::int64_t> peak_resident_bytes();

/// Gives freed memory back to the system and starts a new peak. False where that cannot be done:
/// the peak then holds all that was before.
bool reset_peak_memory();

}  // namespace phytobench
