// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace phytobench {

/// A clock that never jumps, from an arbitrary beginning.
inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace phytobench
