// SPDX-License-Identifier: MIT
// What a pattern would look like if there were nothing to find. Each simulation is a pure function
// of (seed, index): the same for any order or number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Complete spatial randomness with a fixed number of points: `count` independent uniform points of
/// the window, drawn from CounterStream(seed, index).
std::vector<Point2> random_pattern(const Window& window, std::size_t count, std::uint64_t seed,
                                   std::uint64_t index);

/// The same for a window that was guessed as the bounding box of the pattern: stretched to the box,
/// so that points lie on all of its sides, as the observed ones do. Given its bounding box, that is
/// how a completely random pattern is distributed. At least two points; not for polygons.
std::vector<Point2> box_filling_pattern(const Window& window, std::size_t count, std::uint64_t seed,
                                        std::uint64_t index);

/// Random labelling: the same marks in a random order (null model: places are given, marks fall on
/// them by chance).
std::vector<double> relabelled(std::span<const double> marks, std::uint64_t seed,
                               std::uint64_t index);

/// Random labelling of two species: the same places, the species shared out anew by chance in the
/// same numbers.
struct TwoSpecies {
  std::vector<Point2> first, second;
};
TwoSpecies relabelled(std::span<const Point2> first, std::span<const Point2> second,
                      std::uint64_t seed, std::uint64_t index);

/// Random shift (Lotwick and Silverman 1982): all points moved by one uniform vector, those that
/// leave the window coming back in on the opposite side (null model: two species are independent,
/// each with its own structure). On a torus distances within the pattern stay as they are; in a
/// rectangle pairs are torn apart at the seam, so the test is approximate there. ContractViolation
/// for polygons, which have no opposite sides, and for points outside.
std::vector<Point2> torus_shifted(std::span<const Point2> points, const Window& window,
                                  std::uint64_t seed, std::uint64_t index);

}  // namespace phytobench
