// SPDX-License-Identifier: MIT
#include "core/terrain/pictures/map_palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

MapPalette::MapPalette(std::initializer_list<std::string_view> colours) {
  PHYTOBENCH_EXPECT(colours.size() >= 2);
  for (const std::string_view colour : colours) colours_.push_back(parse_colour(colour));
}

Colour MapPalette::at(double share) const {
  const auto last = static_cast<double>(colours_.size() - 1);
  const double place = std::clamp(share, 0.0, 1.0) * last;
  const double below = std::min(std::floor(place), last - 1.0);
  const Colour& a = colours_[static_cast<std::size_t>(below)];
  const Colour& b = colours_[static_cast<std::size_t>(below) + 1];
  const auto mix = [&](double from, double to) { return from + (place - below) * (to - from); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

const MapPalette& insolation_palette() {
  static const MapPalette palette{"#2b1604", "#f2c200", "#ffffff"};
  return palette;
}

const MapPalette& soil_depth_palette() {
  static const MapPalette palette{"#fff6b0", "#cc7722", "#3b1f0b"};
  return palette;
}

const MapPalette& hydrology_palette() {
  static const MapPalette palette{"#ffffff", "#0a1f6b"};
  return palette;
}

const MapPalette& probability_palette() {
  static const MapPalette palette{"#000000", "#808080", "#ffffff"};
  return palette;
}

const MapPalette& height_palette() {
  static const MapPalette palette{"#2f5d34", "#c9b27c", "#ffffff"};
  return palette;
}

Colour kind_colour(std::size_t kind) {
  static const std::array<Colour, 8> colours{parse_colour("#8c564b"), parse_colour("#7f7f7f"),
                                             parse_colour("#bcbd22"), parse_colour("#2ca02c"),
                                             parse_colour("#ff7f0e"), parse_colour("#1f77b4"),
                                             parse_colour("#9467bd"), parse_colour("#17becf")};
  return colours[kind % colours.size()];
}

Colour normal_colour(double east, double south, double up) {
  return {0.5 + 0.5 * east, 0.5 + 0.5 * south, 0.5 + 0.5 * up};
}

}  // namespace phytobench
