// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace phytobench::oracles {

/// Random enough for a test, and nobody else's code.
inline double noise(unsigned k) {
  const double s = std::sin(12.9898 * k + 4.1414) * 43758.5453;
  return s - std::floor(s);
}

}  // namespace phytobench::oracles
