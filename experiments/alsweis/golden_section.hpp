// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace phytobench::experiments::alsweis {

/// The place between two others at which a function with one hill is highest, by golden sections:
/// without any formula that a claim might rest on. Right to a few 1e-8 of the range, for a hilltop
/// is flat.
template <class Function>
double place_of_highest(const Function& function, double low, double high) {
  for (int i = 0; i < 80; ++i) {
    const double width = (high - low) / std::numbers::phi;
    if (function(high - width) < function(low + width))
      low = high - width;
    else
      high = low + width;
  }
  return 0.5 * (low + high);
}

}  // namespace phytobench::experiments::alsweis
