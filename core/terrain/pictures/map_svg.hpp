// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/picture/image.hpp"
#include "core/terrain/pictures/map_image.hpp"

namespace phytobench {

/// A bar of colours with numbers at its ends and in the middle.
struct ColourBar {
  const MapPalette* palette = nullptr;
  MapScale scale;
};

/// A colour and what it stands for.
struct ColourEntry {
  Colour colour;
  std::string text;
};

/// What stands around a map.
struct MapLegend {
  std::string title;
  std::string unit;  ///< of the colour bar; may be empty
  ColourBar bar;     ///< none without a palette
  std::vector<ColourEntry> entries;
  double width_m = 0.0;  ///< of the whole map, from west to east
  double depth_m = 0.0;  ///< from north to south
  /// What it means where the image is transparent: "no data". Such cells are hatched, in colours
  /// that no palette has, since white is one end of most. Empty: there are none.
  std::string without;
  std::string note;  ///< in small letters below all, such as a source; may be empty
};

/// Of these hatches: ground and stripes.
Colour hatch_ground();
Colour hatch_stripe();

/// The map with title, legend, scale bar and an arrow towards north, which is up. The image is
/// stretched to the map's true proportions.
std::string map_svg(const Image& image, const MapLegend& legend);

/// The greatest of 1, 2, 5, 10, 20, ... metres that is at most a third of the map's width.
double scale_bar_length(double width_m);

}  // namespace phytobench
