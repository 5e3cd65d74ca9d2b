// SPDX-License-Identifier: MIT
// Which discs of a layered grid share a layer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace phytobench {

/// Discs whose radii have binary exponents within a range; the bits of a double above its mantissa
/// count as exponent.
struct SizeClass {
  std::size_t first_exponent = 0;
  std::size_t last_exponent = 0;
  std::size_t count = 0;
  double largest = 0.0;  ///< radius
};

/// Number of exponents, and that of a radius >= 0.
inline constexpr std::size_t exponent_count = 2048;
std::size_t exponent_of(double radius);

/// From the largest radii to the smallest, without radii of 0. Few classes mean wide cells, in
/// which small discs look at many others in vain; many classes mean many grids to look into. Which
/// is cheaper is estimated from how many discs of each size there are, as if they were spread
/// evenly over `area` (0 is allowed).
std::vector<SizeClass> size_classes(std::span<const double> radii, double area);

}  // namespace phytobench
