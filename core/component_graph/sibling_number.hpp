// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace phytobench {

/// Which of its siblings an instance is: those that one link made below one parent.
struct SiblingNumber {
  std::uint32_t i = 1;  ///< 1 ... n
  std::uint32_t n = 1;
  friend bool operator==(const SiblingNumber&, const SiblingNumber&) = default;
};

}  // namespace phytobench
