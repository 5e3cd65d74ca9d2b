// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "core/picture/image.hpp"

namespace phytobench {

/// Colours from the least to the greatest value, mixed evenly between (sRGB).
class MapPalette {
 public:
  /// "#rrggbb", at least two.
  MapPalette(std::initializer_list<std::string_view> colours);

  /// `share` from 0 to 1; beyond, the nearest end's.
  Colour at(double share) const;

 private:
  std::vector<Colour> colours_;
};

/// Colour codes in the order that [Lesser2019] sec. 10.3 names; it prints no numbers, these are
/// ours.
const MapPalette& insolation_palette();   ///< dark brown, yellow, white
const MapPalette& soil_depth_palette();   ///< light yellow (shallow), ochre, dark brown (deep)
const MapPalette& hydrology_palette();    ///< white, dark blue
const MapPalette& probability_palette();  ///< black, grey (50 %), white
const MapPalette& height_palette();       ///< our own: dark green, light brown, white

/// For maps of kinds: the colour of kind 0, 1, ..., all told apart up to eight; then they repeat.
Colour kind_colour(std::size_t kind);

/// Of a surface that looks there, as is usual for normal maps: east is red, south green, up blue
/// ([Lesser2019] sec. 10.3, where the north is not red as printed: erratum E30).
Colour normal_colour(double east, double south, double up);

}  // namespace phytobench
