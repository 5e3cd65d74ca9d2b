// SPDX-License-Identifier: MIT
// From a painted grey picture to plants: the interactive distribution of [Alsweis] sec. 2.4.1.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// The order in which the pixels of a row are visited.
enum class HalftoneScan {
  plain,       ///< every row from left to right, as published
  serpentine,  ///< every second row from right to left; breaks up the worm-like artefacts
};

/// Error diffusion after Floyd and Steinberg 1976, to which the dissertation refers without
/// printing the weights: 7, 3, 5 and 1 of 16 go ahead, below behind, below and below ahead. A pixel
/// becomes black from 0.5 on; each black pixel gives one point at its centre. `darkness` holds
/// width * height values from 0 (white) to 1 (black), row by row, the top row first, as pictures
/// are stored; the picture fills the rectangle. What would go beyond the picture's border is lost,
/// at most (11 height + 9 width) / 32 points. ContractViolation for values out of range, InputError
/// beyond most_points.
std::vector<Point2> halftone_points(std::span<const double> darkness, std::size_t width,
                                    std::size_t height, const Rectangle& rectangle,
                                    HalftoneScan scan = HalftoneScan::plain);

}  // namespace phytobench
