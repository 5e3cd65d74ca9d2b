// SPDX-License-Identifier: MIT
// One row of a terrain against the shadows that reach it along parallel lines: vectors across the
// lines. A key is a height less the rise of a ray up to there, so that along a line a vertex is
// dark iff an earlier key is greater.
#pragma once

#include <cstddef>
#include <cstdint>

namespace phytobench {

/// A row of vertices as the sweep sees it.
struct SweepRow {
  const double* heights = nullptr;
  const double* column_rise = nullptr;  ///< of a ray towards the sun, m, at each column
  double rise = 0.0;                    ///< the same of this row; both are taken off a height
  std::size_t columns = 0;
};

/// Takes the greatest key so far of the line of each column; writes which vertices are lit, and
/// updates the lines.
void sweep_lines(const SweepRow& row, double* lines, std::uint64_t* lit);

/// The same where the lines pass between vertices: the line of column c lies `aside` (0 < aside <
/// 1) columns before vertex c, and what reaches vertex c comes from this line and the next one,
/// lines[c + 1]. Not for aside = 0: those lines meet vertices.
void sweep_sheared_lines(const SweepRow& row, double aside, double* lines, std::uint64_t* lit);

/// A ray that comes from the vertex of its line keeps within one column of it. `greatest` bounds
/// all keys that such rays may have met, `least` what they have met in any case; `margin` covers
/// what is rounded elsewhere. There is a line before the first column and one after the last.
struct SweepBounds {
  double* greatest = nullptr;
  double* least = nullptr;
  double margin = 0.0;
};
/// Writes which vertices are certainly lit, and which are not certainly dark; updates the bounds.
void sweep_bounds(const SweepRow& row, const SweepBounds& bounds, std::uint64_t* surely_lit,
                  std::uint64_t* maybe_lit);

}  // namespace phytobench
