// SPDX-License-Identifier: MIT
// Suns and height fields that the experiments on [Lesser2019] share.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/made/fractal_terrain.hpp"
#include "core/terrain/shadow/lit_maps.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/sun/hourly_path.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench::experiments::lesser2019 {

/// Listing 9.5: m between pixels.
inline constexpr double thesis_cell = 16.0;

/// Sec. 9.2.3: hours of the example, which the default of the program has, too (figure 10.4).
inline constexpr int thesis_hours = 13;

/// The path with directions rounded to four decimals, as listing 9.7 does: whoever compares the
/// printed march with anything gives both the same suns.
inline std::vector<SunDirection> rounded_path(const HourlyPath& path) {
  std::vector<SunDirection> suns;
  for (const SunAngles& angles : sun_angles(path)) suns.push_back(rounded(direction_of(angles), 4));
  return suns;
}

inline std::vector<SunDirection> thesis_path(double max_elevation = 90.0) {
  return rounded_path({.hours = thesis_hours, .max_elevation = max_elevation});
}

/// What an engine finds, and what it took.
struct Cast {
  LitMaps lit;
  ShadowWork work;
};

inline Cast cast_by(std::string_view engine, const HeightField& field,
                    const std::vector<SunDirection>& suns, int threads = 1) {
  Cast cast;
  cast.work =
      shadow_engine_named(engine).create()->cast(field, suns, {.threads = threads}, cast.lit);
  return cast;
}

/// height(column, row) in metres at each vertex of a square field.
template <class Height>
HeightField square_field(int side, double cell, const Height& height) {
  HeightField field(side, side, cell, cell);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) field.at(column, row) = height(column, row);
  return field;
}

/// Rough land on square cells, from 0 to `relief` metres high.
inline HeightField fractal_field(int side, double cell, double relief, std::uint64_t seed,
                                 int threads = 1) {
  return noise_terrain({side, side, cell, cell},
                       {.seed = seed, .relief_m = relief, .threads = threads});
}

}  // namespace phytobench::experiments::lesser2019
