// SPDX-License-Identifier: MIT
// Competition on square cells, as grid-based models have it: a plant has the cells whose centers
// lie in its disc, and a cell is one unit of ground.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/overlap/discs.hpp"
#include "core/overlap/sharing_law.hpp"

namespace phytobench {

struct CellShares {
  std::vector<double> won;          ///< area of cells that each disc wins
  std::vector<std::int64_t> cells;  ///< how many it has, shared or not
};

/// What ground_shares() says exactly, on cells of that side. Cells begin at 0, on a torus at its
/// lower left corner.
///
/// Error: of a disc of radius r, |cells side^2 - pi r^2| <= pi (sqrt(2) r side + side^2 / 2). Over
/// random places of the grid the standard deviation is 0.68 sqrt(r side) side for r >> side
/// (Kendall 1948): relatively, it falls as (side / r)^1.5. What a disc wins is off by as much for
/// every arc that bounds or divides it. A disc narrower than sqrt(2) sides may have no cell at all
/// and win nothing, or have one that is many times its size.
///
/// Time grows as all discs' boxes over side^2; memory as the cells of one row. Throws InputError
/// for a side that is not a positive number, does not divide both sides of the torus (to 1e-9), or
/// lays more than 50 million cells between where they begin and a disc's far end. Discs must be fit
/// (problem_with()); ContractViolation for a law that is not.
CellShares cell_shares(const Discs& discs, const Ground& ground, double side,
                       const SharingLaw& law);

struct CellField {
  /// Mean over a plant's cells of all other plants' fields; NaN for a plant without a cell.
  std::vector<double> mean;
  std::vector<std::int64_t> cells;
};

/// F_A of Berger and Hildenbrandt 2000 on cells, as pyMANGA computes it: fields are those of
/// NeighbourField, read at the centers of cells. Errors as above; pyMANGA itself refuses cells
/// wider than 0.25 m.
CellField cell_field(const Discs& zones, std::span<const double> stem_radius, double field_at_rim,
                     const Ground& ground, double side);

}  // namespace phytobench
