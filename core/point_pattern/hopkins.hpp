// SPDX-License-Identifier: MIT
// The Hopkins index: how far a random place is from the nearest plant, against how far plants are
// from each other.
#pragma once

#include <cstddef>
#include <span>

#include "core/point_pattern/window.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// About 1 for a random pattern, above 1 for a clustered one, below 1 for a regular one: the
/// orientation of [Alsweis] (2.8). Others print its reciprocal (spatstat's `hopskel` that of
/// squared_ratio), or H / (1 + H) (R's `hopkins`, of squared_ratio).
struct HopkinsIndex {
  double mean_ratio = 0.0;     ///< <|x - p|> / <|p - q|>, exponent 1: [Alsweis] (2.8) for i != j
  double squared_ratio = 0.0;  ///< <|x - p|^2> / <|p - q|^2>, exponent 2: Hopkins 1954
};

/// The mean over x taken by integration over Voronoi cells: no random places, no sampling noise.
/// Distances go round on a torus; nothing is corrected at the edges of other windows. Infinite if
/// every point has a twin at its place; NaN for fewer than two points. Points must lie in the
/// window. The same for any number of threads.
HopkinsIndex hopkins_exact(std::span<const Point2> points, const Window& window, int threads = 1);

/// The mean over x taken over `places` (at least 1) random places, as in the literature. Scatters
/// around hopkins_exact() by some 0.53 / sqrt(places).
HopkinsIndex hopkins_sampled(std::span<const Point2> points, const Window& window,
                             std::size_t places, UnitStream& stream, int threads = 1);

}  // namespace phytobench
