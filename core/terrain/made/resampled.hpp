// SPDX-License-Identifier: MIT
// Parts, repetitions and other grids of a map. Where a map lies on Earth goes along, if it is
// known.
#pragma once

#include <optional>

#include "core/terrain/files/height_file.hpp"
#include "core/terrain/height_field.hpp"

namespace phytobench {

/// The same area on square cells of that width: the first vertex stays where it is, and no vertex
/// lies beyond the last. Heights between vertices are bilinear; without data where one of the
/// vertices that a height is made of is. Throws InputError if that makes more than 2^28 vertices.
HeightField on_square_cells(const HeightField& field, double cell_m);

/// The columns and rows from there on. Throws InputError for a part that is not all on the map.
struct MapPart {
  int first_column = 0;
  int first_row = 0;
  int columns = 1;
  int rows = 1;
};
HeightField cropped(const HeightField& field, const MapPart& part);

/// A map of any size made of the field and its mirror images, side by side, so that heights are
/// without steps at the seams. Mirrors at the border vertices, which are not repeated.
HeightField tiled(const HeightField& field, int columns, int rows);

/// Where those maps lie: of a part, and of a map on other cells, both counted from the same first
/// vertex.
GeoReference place_of_part(const GeoReference& place, const MapPart& part);
GeoReference place_on_cells(const GeoReference& place, const HeightField& field,
                            const HeightField& resampled);

}  // namespace phytobench
