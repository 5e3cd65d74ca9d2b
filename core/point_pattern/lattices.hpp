// SPDX-License-Identifier: MIT
// Regular patterns, row by row from the lower left. All are periodic on the torus of their
// rectangle: the gaps across its borders are those of the interior. Columns, rows and both sides of
// the rectangle are > 0 (ContractViolation otherwise); InputError beyond most_points.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// The centres of columns x rows equal cells. Truly square where the cells are.
std::vector<Point2> square_lattice(const Rectangle& rectangle, std::size_t columns,
                                   std::size_t rows);

/// As square_lattice(), every other row shifted by half a step; an even number of rows, so that
/// they still alternate across the border. The triangles are equilateral where
/// height / rows = sqrt(3) / 2 * width / columns.
std::vector<Point2> triangular_lattice(const Rectangle& rectangle, std::size_t columns,
                                       std::size_t rows);

/// One uniform point in each of the cells of square_lattice().
std::vector<Point2> jittered_lattice(const Rectangle& rectangle, std::size_t columns,
                                     std::size_t rows, UnitStream& stream);

}  // namespace phytobench
