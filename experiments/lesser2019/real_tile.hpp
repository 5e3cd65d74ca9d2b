// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/record.hpp"
#include "core/terrain/files/height_file.hpp"
#include "core/terrain/height_field.hpp"
#include "core/terrain/made/resampled.hpp"
#include "reference/data_folder.hpp"

namespace phytobench::experiments::lesser2019 {

/// Real land (reference/terrains/README.md): hills with cells that are not square. In smoke runs a
/// part of it.
inline HeightField real_tile(Tier tier) {
  constexpr int part = 112;
  const HeightField tile =
      read_height_file(data_folder() / "terrains" / "jacksboro_srtm_3arcsec.asc", {}).field;
  return tier == Tier::smoke
             ? cropped(tile, {.first_column = 60, .first_row = 90, .columns = part, .rows = part})
             : tile;
}

/// The same on squares of 90 m, as the thesis has them.
inline HeightField real_tile_on_squares(Tier tier) {
  return on_square_cells(real_tile(tier), 90.0);
}

}  // namespace phytobench::experiments::lesser2019
