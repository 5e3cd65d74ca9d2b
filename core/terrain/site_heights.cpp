// SPDX-License-Identifier: MIT
// Heights of a site: from its file, or made.
#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/made/analytic_terrains.hpp"
#include "core/terrain/made/fractal_terrain.hpp"
#include "core/terrain/site.hpp"

namespace phytobench {

namespace {

MapGrid made_grid_of(const HeightSource& source) {
  const double width = source.cell_width.value_or(made_cell);
  return {source.columns, source.rows, width, source.cell_depth.value_or(width)};
}

HeightFile made_heights(const HeightSource& source) {
  const MapGrid grid = made_grid_of(source);
  const FractalOptions rough{
      .seed = source.seed, .relief_m = source.relief, .persistence = source.roughness};
  const auto made = [](HeightField field, const char* name) {
    return HeightFile{.field = std::move(field), .place = {}, .format = name};
  };
  switch (source.made) {
    case MadeTerrain::fractal:
      return made(noise_terrain(grid, rough), "fractal");
    case MadeTerrain::diamond_square:
      return made(diamond_square_terrain(grid, rough), "diamond-square");
    case MadeTerrain::flat:
      return made(flat_terrain(grid, 0.0), "flat");
    case MadeTerrain::plane:
      return made(plane_terrain(grid, source.slope_degrees, source.aspect_degrees), "plane");
    case MadeTerrain::ridge:
      return made(ridge_terrain(grid, source.slope_degrees), "ridge");
    case MadeTerrain::valley:
      return made(v_valley_terrain(grid, source.slope_degrees), "valley");
    case MadeTerrain::cone:
      return made(cone_terrain(grid, source.slope_degrees, source.radius), "cone");
    case MadeTerrain::hemisphere:
      return made(hemisphere_terrain(grid, source.radius), "hemisphere");
    case MadeTerrain::ring_wall:
      return made(ring_wall_terrain(grid, source.radius, source.thickness, source.relief),
                  "ring wall");
    case MadeTerrain::needle:
      return made(needle_terrain(grid, source.relief), "needle");
  }
  throw ContractViolation("a terrain that cannot be made");
}

/// Without a neighbour to the east or west, or to the north or south, nothing has a slope.
void refuse_lines(const HeightField& field, const std::string& name) {
  if (field.columns() < 2 || field.rows() < 2)
    throw InputError(
        fmt::format("{}: has {} columns and {} rows, and of one alone there are no slopes; give at "
                    "least 2 of each",
                    name, field.columns(), field.rows()));
}

HeightFile read_heights(const HeightSource& source) {
  HeightFile heights = read_height_file(source.file, {.height_conversion = source.conversion,
                                                      .cell_width = source.cell_width,
                                                      .cell_depth = source.cell_depth});
  refuse_lines(heights.field, source.file);
  return heights;
}

}  // namespace

HeightFile heights_of(const SiteDescription& site) {
  if (site.heights.file.empty()) return made_heights(site.heights);
  try {
    return read_heights(site.heights);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: heights.file: {}", site.place_of("heights.file"), error.what()));
  }
}

}  // namespace phytobench
