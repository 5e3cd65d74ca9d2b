// SPDX-License-Identifier: MIT
// A landscape of cells that each hold a number of plants: a cellular automaton without individual
// plants.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/population/logistic_map.hpp"

namespace phytobench {

/// Cells of a landscape, row by row: cell (x, y) has the number y * width + x.
struct CellGrid {
  std::size_t width = 1;
  std::size_t height = 1;

  std::size_t size() const { return width * height; }
};

/// What lies beyond the outermost cells.
enum class CellBorder {
  torus,       ///< the other side
  reflecting,  ///< a copy of the cell itself: nobody leaves
  absorbing,   ///< empty land: who leaves is lost
};

/// How counts of one year become those of the next. `inflow` is [Alsweis] (2.12), the sum of the
/// four neighbours less four times the cell.
enum class CellStep {
  unclipped,      ///< (2.13): N + alpha N + beta N^2 + gamma inflow; counts may fall below 0
  positive_part,  ///< (2.14): the same, counts below 0 become 0, which creates plants
  /// First every cell grows to M = max(0, N + alpha N + beta N^2), then M + min(gamma, 1/4) inflow
  /// of M: no more plants leave than there are, so none has to be created.
  conserving,
};

std::string_view name_of(CellBorder border);
std::string_view name_of(CellStep step);

struct CellRule {
  double migration = 0.0;  ///< gamma: share of a cell that moves to each neighbour, in [0, 1]
  CellStep step = CellStep::conserving;
  CellBorder border = CellBorder::reflecting;
};

/// Bounds on gamma. [Alsweis] asks for gamma < 1 only.
///
/// A pattern that (2.12) multiplies by mu, in [-8, 0], and that is small beside the equilibrium of
/// (2.13), is multiplied by (1 - alpha) + gamma mu each year. For 0 < alpha < 2 that is below 1 for
/// all mu, and above -1 for all mu if it is for the checkerboard, mu = -8: gamma < (2 - alpha) / 8.
/// In the conserving step the factor is (1 - alpha) (1 + gamma mu), whose second part lies within
/// [-1, 1] for gamma <= 1/4: there the equilibrium is as stable as that of a single cell.
///
/// With m the largest count of a year, none of the next exceeds
///     max over N of ((1 + alpha - 4 gamma) N + beta N^2) + 4 gamma m = c + 4 gamma m,
/// c = (1 + alpha - 4 gamma)^2 / (4 |beta|) in (2.14), where nothing is below 0. So for
/// gamma < 1/4 counts end up below every bound beyond c / (1 - 4 gamma), and never exceed it once
/// below. For gamma > 1/4 a checkerboard of 0 and large counts turns into its negative, 4 gamma
/// times as large, each year: clipped at 0, it grows without bound.
///
/// (2.13) takes no count in [0, (1 + alpha - 4 gamma) / |beta|] below 0 if no neighbour is. That
/// contains the interval of the bound, [0, c / (1 - 4 gamma)], if alpha <= 3 (1 - 4 gamma): from
/// there on clipping never happens.
inline constexpr double bounded_migration = 0.25;

/// (2 - alpha) / 8: the uniform equilibrium of (2.13) and (2.14) is stable below it, 0 < alpha < 2.
/// Above it a checkerboard grows, on a torus with two even sides; other shapes bear a little more.
constexpr double stable_migration(double fertility) {
  return (2.0 - fertility) / 8.0;
}

/// (1 - alpha / 3) / 4: up to it no count within count_bound() gets negative in (2.13).
constexpr double unclipped_migration(double fertility) {
  return (1.0 - fertility / 3.0) / 4.0;
}

/// c / (1 - 4 gamma), see above: counts of (2.14) fall to it or stay below. Mortality below 0,
/// migration in [0, 1/4); ContractViolation otherwise.
double count_bound(const LogisticMap& growth, double migration);

/// Counts are real numbers, never rounded. A step gives the same bits for any number of threads,
/// and mirrored or turned counts give mirrored or turned bits.
class CellPopulation {
 public:
  /// Empty cells that are all alike. At least one cell, migration in [0, 1]; ContractViolation
  /// otherwise.
  CellPopulation(const CellGrid& grid, const CellRule& rule, const LogisticMap& growth);
  /// The same with a map of habitats: one growth for each cell.
  CellPopulation(const CellGrid& grid, const CellRule& rule, std::vector<LogisticMap> growth);

  const CellGrid& grid() const { return grid_; }
  const CellRule& rule() const { return rule_; }

  /// One count per cell, row by row.
  std::span<double> counts() { return counts_; }
  std::span<const double> counts() const { return counts_; }
  double count_at(std::size_t x, std::size_t y) const { return counts_[y * grid_.width + x]; }

  /// All counts, added up row by row.
  double total() const;

  /// One year.
  void step(int threads = 1);

 private:
  void grow(int threads);
  template <class Growth>
  void migrate(double migration, const Growth& growth, int threads);

  CellGrid grid_;
  CellRule rule_;
  std::vector<LogisticMap> growth_;  ///< one for all cells, or one for each
  std::vector<double> counts_;
  std::vector<double> next_;
  std::vector<double> empty_row_;  ///< beyond an absorbing border
};

}  // namespace phytobench
