// SPDX-License-Identifier: MIT
// Rough terrain from a seed: pure functions of their options, the same bytes for any number of
// threads and on any platform.
#pragma once

#include <cstdint>

#include "core/terrain/height_field.hpp"
#include "core/terrain/made/analytic_terrains.hpp"

namespace phytobench {

struct FractalOptions {
  std::uint64_t seed = 1;
  double relief_m = 400.0;   ///< from the lowest vertex, at 0, to the highest
  double persistence = 0.5;  ///< of each octave's swing to the one before, above 0 to 1
  /// Of noise, each twice as fine as the one before; the first spans the map's longer side. 0: as
  /// many as are not finer than two cells.
  int octaves = 0;
  int threads = 1;
};

/// Octaves of value noise: random numbers at the corners of a lattice, between them a smooth blend.
/// At most 14 octaves.
HeightField noise_terrain(const MapGrid& grid, const FractalOptions& options);

/// Midpoint displacement by diamonds and squares (Fournier, Fussell and Carpenter 1982,
/// Communications of the ACM 25), on the smallest square of 2^k + 1 vertices that covers the map,
/// which is its north-west corner. Counts cells as square; `octaves` is not asked.
HeightField diamond_square_terrain(const MapGrid& grid, const FractalOptions& options);

}  // namespace phytobench
