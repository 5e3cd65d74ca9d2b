// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/picture/image.hpp"
#include "core/terrain/pictures/map_palette.hpp"
#include "core/terrain/relief.hpp"
#include "core/terrain/site_model.hpp"

namespace phytobench {

/// The values that the ends of a palette stand for.
struct MapScale {
  double low = 0.0;
  double high = 1.0;

  /// 0 to 1 from one end to the other; everything is 0 where both are the same.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.0; }
};

/// From the least to the greatest number of the map; {0, 0} without any.
MapScale scale_of(std::span<const double> values);

/// Every how many columns and rows is shown, so that neither side has more than `most` pixels.
int thinning(int columns, int rows, int most);

/// A pixel for each cell, or, thinned out, for the first of `every` by `every`; transparent where
/// there is no number: white is one end of most palettes.
Image map_image(const TerrainMap& map, const MapScale& scale, const MapPalette& palette,
                int every = 1);

/// The same of directions; `field` says where there is data.
Image normal_image(const HeightField& field, std::span<const SurfaceGradient> surfaces,
                   int every = 1);

/// The same of kinds; -1 is transparent.
Image kind_image(int columns, int rows, std::span<const std::int16_t> kinds, int every = 1);

}  // namespace phytobench
