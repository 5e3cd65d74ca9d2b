// SPDX-License-Identifier: MIT
// Terrains and suns for tests of shadows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/random/counter_stream.hpp"
#include "core/terrain/height_field.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/sun/hourly_path.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench::testing_terrains {

struct Terrain {
  std::string name;
  HeightField field;
};

/// height(column, row, unit) at every vertex; `unit` is a random number of that vertex.
template <class Height>
HeightField made(int columns, int rows, double width, double depth, std::uint64_t seed,
                 const Height& height) {
  HeightField field(columns, rows, width, depth);
  CounterStream stream(seed, 0);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      field.at(column, row) = height(column, row, stream.next_unit());
  return field;
}

/// Octaves of smoothed noise, each twice as fine and half as high as the one before.
inline HeightField fractal(int columns, int rows, double relief, std::uint64_t seed,
                           double width = 16.0, double depth = 16.0) {
  HeightField field(columns, rows, width, depth);
  double amplitude = 1.0;
  for (int step = std::max(columns, rows) / 2; step >= 1; step /= 2, amplitude /= 2.0) {
    const auto knot = [&](int i, int j) {
      return random_unit(seed, static_cast<std::uint64_t>(step),
                         static_cast<std::uint64_t>(j) * 4096 + static_cast<std::uint64_t>(i));
    };
    const auto smooth = [](double x) { return x * x * (3.0 - 2.0 * x); };
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const int i = column / step, j = row / step;
        const double x = smooth(static_cast<double>(column % step) / step);
        const double y = smooth(static_cast<double>(row % step) / step);
        const double north = knot(i, j) + x * (knot(i + 1, j) - knot(i, j));
        const double south = knot(i, j + 1) + x * (knot(i + 1, j + 1) - knot(i, j + 1));
        field.at(column, row) += amplitude * (north + y * (south - north));
      }
  }
  const HeightRange range = height_range(field);
  const double scale = range.highest > range.lowest ? relief / (range.highest - range.lowest) : 0.0;
  for (double& height : field.heights()) height = (height - range.lowest) * scale;
  return field;
}

/// A share of the vertices loses its data, and so does a block of them.
inline HeightField with_holes(HeightField field, double share, std::uint64_t seed) {
  CounterStream stream(seed, 1);
  for (double& height : field.heights())
    if (stream.next_unit() < share) height = HeightField::no_data;
  for (int row = field.rows() / 3; row < field.rows() / 2; ++row)
    for (int column = field.columns() / 4; column < field.columns() / 2; ++column)
      field.at(column, row) = HeightField::no_data;
  return field;
}

inline HeightField raised_by(HeightField field, double height) {
  for (double& h : field.heights()) h += height;
  return field;
}

/// The path of [Lesser2019] as it computes with it: directions of four decimals.
inline std::vector<SunDirection> hourly_suns(int hours = 13, double max_elevation = 90.0) {
  std::vector<SunDirection> suns;
  for (const SunAngles& angles : sun_angles({.hours = hours, .max_elevation = max_elevation}))
    suns.push_back(rounded(direction_of(angles), 4));
  return suns;
}

/// Low and high suns all round, along the axes, along diagonals, and where there is nothing to do.
inline std::vector<SunDirection> suns_all_round() {
  std::vector<SunDirection> suns = hourly_suns();
  for (const double elevation : {0.0, 5.0, 25.0, 60.0})
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 22.5)
      suns.push_back(direction_of({elevation, azimuth}));
  for (const double azimuth : {3.0, 123.4, 201.7, 299.9})
    suns.push_back(direction_of({12.0, azimuth}));
  suns.push_back({-3.0, 1.0, 0.5});  // no unit vector; along every third vertex
  suns.push_back({2.0, -1.0, 0.25});
  suns.push_back({0.0, 0.0, 1.0});
  suns.push_back(direction_of({-4.0, 30.0}));
  suns.push_back({0.0, 0.0, -1.0});
  return suns;
}

inline std::vector<Terrain> terrains() {
  const HeightField steep = fractal(70, 61, 700.0, 1);
  return {
      {"steep fractal", steep},
      {"gentle fractal, columns a multiple of 64", fractal(128, 40, 60.0, 2)},
      {"cells that are not square", fractal(67, 50, 900.0, 3, 74.3, 92.5)},
      {"cells of a tenth", fractal(33, 47, 3.0, 4, 0.1, 0.1)},
      {"holes", with_holes(fractal(66, 45, 400.0, 5), 0.1, 5)},
      {"mostly holes", with_holes(fractal(31, 40, 400.0, 6), 0.7, 6)},
      {"nothing but holes", HeightField(9, 7, 1.0, 1.0, HeightField::no_data)},
      {"few whole numbers",
       made(50, 43, 1.0, 1.0, 7, [](int, int, double u) { return std::floor(4 * u); })},
      {"plateaus",
       made(45, 37, 2.0, 2.0, 8, [](int c, int r, double) { return 6.0 * ((c / 7 + r / 5) % 3); })},
      {"single posts",
       made(60, 41, 16.0, 16.0, 9, [](int, int, double u) { return u < 0.02 ? 150.0 : 0.0; })},
      {"noise", made(39, 65, 5.0, 3.0, 10, [](int, int, double u) { return 30.0 * u; })},
      {"below the sea", raised_by(fractal(40, 40, 300.0, 11), -11000.0)},
      {"very high", raised_by(fractal(40, 40, 300.0, 12), 1e9)},
      {"huge", made(20, 21, 1e150, 1e150, 13, [](int, int, double u) { return 1e151 * u; })},
      {"one row", fractal(90, 1, 300.0, 14)},
      {"one column", fractal(1, 90, 300.0, 15)},
      {"two by two", fractal(2, 2, 20.0, 16)},
      {"one vertex", HeightField(1, 1, 16.0, 16.0, 5.0)},
      {"three rows", fractal(75, 3, 300.0, 17)},
      {"flat", HeightField(30, 30, 16.0, 16.0, 100.0)},
  };
}

inline LitMaps lit_by(std::string_view engine, const HeightField& field,
                      const std::vector<SunDirection>& suns, int threads = 1) {
  LitMaps lit;
  shadow_engine_named(engine).create()->cast(field, suns, {.threads = threads}, lit);
  return lit;
}

inline std::vector<const ShadowEngineDescriptor*> engines_that_are(bool exact) {
  std::vector<const ShadowEngineDescriptor*> engines;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines())
    if (engine->built() && engine->exact == exact) engines.push_back(engine);
  return engines;
}

/// The first difference, for messages.
inline std::string difference(const LitMaps& a, const LitMaps& b) {
  if (a.columns() != b.columns() || a.rows() != b.rows() || a.positions() != b.positions())
    return "another shape";
  for (std::size_t position = 0; position < a.positions(); ++position)
    for (int row = 0; row < a.rows(); ++row)
      for (int column = 0; column < a.columns(); ++column)
        if (a.is_lit(position, column, row) != b.is_lit(position, column, row))
          return "position " + std::to_string(position) + ", column " + std::to_string(column) +
                 ", row " + std::to_string(row) +
                 (a.is_lit(position, column, row) ? ": lit against dark" : ": dark against lit");
  return a == b ? "" : "bits beyond the last column";
}

}  // namespace phytobench::testing_terrains
