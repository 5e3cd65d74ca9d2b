// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/population/cell_population.hpp"

namespace phytobench {

/// One landscape of a row of landscapes.
struct CellMapPanel {
  CellGrid grid;
  std::vector<double> counts;  ///< one per cell, row by row; the first row is drawn on top
  std::string caption;
};

/// Landscapes side by side in eight shades of green, from bare up to `full` and beyond, with their
/// key below, as an SVG that follows the page's text colour. Counts below half a shade, negative
/// and NaN are bare. `title` is read aloud and shown as a tooltip. Cells of one shade that lie side
/// by side in a row take some ten bytes together. All grids of one size, full > 0;
/// ContractViolation otherwise.
std::string cell_map_svg(const std::vector<CellMapPanel>& panels, double full,
                         const std::string& title);

}  // namespace phytobench
