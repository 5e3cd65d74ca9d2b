// SPDX-License-Identifier: MIT
#include "core/terrain/pictures/map_image.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// colour(column, row) of every cell shown, or nothing.
template <class ColourOf>
Image painted(int columns, int rows, int every, const ColourOf& colour_of) {
  PHYTOBENCH_EXPECT(columns > 0 && rows > 0 && every > 0);
  const auto shown = [every](int cells) { return (cells - 1) / every + 1; };
  Image image(shown(columns), shown(rows));
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column)
      image.at(column, row) = colour_of(column * every, row * every);
  return image;
}

constexpr Pixel nothing{0, 0, 0, 0};

}  // namespace

MapScale scale_of(std::span<const double> values) {
  MapScale scale{HUGE_VAL, -HUGE_VAL};
  for (const double value : values) {
    if (std::isnan(value)) continue;
    scale.low = std::min(scale.low, value);
    scale.high = std::max(scale.high, value);
  }
  return scale.low > scale.high ? MapScale{0.0, 0.0} : scale;
}

int thinning(int columns, int rows, int most) {
  PHYTOBENCH_EXPECT(most > 0);
  return (std::max(columns, rows) - 1) / most + 1;
}

Image map_image(const TerrainMap& map, const MapScale& scale, const MapPalette& palette,
                int every) {
  return painted(map.columns, map.rows, every, [&](int column, int row) {
    const double value = map.at(column, row);
    return std::isnan(value) ? nothing : to_pixel(palette.at(scale.share(value)));
  });
}

Image normal_image(const HeightField& field, std::span<const SurfaceGradient> surfaces, int every) {
  PHYTOBENCH_EXPECT(surfaces.size() == field.size());
  return painted(field.columns(), field.rows(), every, [&](int column, int row) {
    if (!field.has_data(column, row)) return nothing;
    const Vector3 normal = surface_normal(surfaces[field.index(column, row)]);
    return to_pixel(normal_colour(normal.x, normal.y, normal.z));
  });
}

Image kind_image(int columns, int rows, std::span<const std::int16_t> kinds, int every) {
  return painted(columns, rows, every, [&](int column, int row) {
    const int kind = kinds[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(column)];
    return kind < 0 ? nothing : to_pixel(kind_colour(static_cast<std::size_t>(kind)));
  });
}

}  // namespace phytobench
