// SPDX-License-Identifier: MIT
#include "core/point_pattern/close_pairs.hpp"

#include <algorithm>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// How many cells away points within `distance` can be; 0 if there is but one cell.
std::int64_t cells_within(double distance, const GridAxis& axis) {
  if (axis.cells == 1) return 0;
  return static_cast<std::int64_t>(distance * axis.inverse_edge + grid_slack) + 1;
}

bool is_cramped(const GridAxis& axis, std::int64_t reach) {
  return axis.joined && 2 * (reach + 1) >= axis.cells;
}

double expected_reach(const Window& window, double reach) {
  PHYTOBENCH_EXPECT(std::isfinite(reach) && reach >= 0.0);
  const Rectangle& box = window.bounding_box();
  PHYTOBENCH_EXPECT(window.kind() != WindowKind::torus ||
                    2.0 * reach < std::min(box.width(), box.height()));
  return reach;
}

}  // namespace

ClosePairs::ClosePairs(std::span<const Point2> points, const Window& window, double reach)
    : window_(window),
      // A little wider than a third of the reach, so that slack costs no further row of cells.
      grid_(points, window, 0.5,
            expected_reach(window, reach) / static_cast<double>(steps_) * (1.0 + grid_slack)),
      limit_(largest_square(reach)),
      row_reach_(cells_within(reach, grid_.rows())) {
  for (std::int64_t up = 0; up <= row_reach_; ++up) {
    // A row `up` rows away lies at least up - 1 edges off; the circle is narrower there.
    const double gap =
        std::max(0.0, (static_cast<double>(up - 1) - grid_slack) * grid_.rows().edge);
    const double half_width = std::sqrt(std::max(0.0, reach * reach - gap * gap));
    column_reach_[static_cast<std::size_t>(up)] = cells_within(half_width, grid_.columns());
  }
  always_wraps_ =
      is_cramped(grid_.rows(), row_reach_) || is_cramped(grid_.columns(), column_reach_[0]);
  // Few blocks for few points: each costs a set of sums.
  block_count_ = std::clamp<std::size_t>(points.size() / 1024, 1, 64);
  block_count_ = std::min(block_count_, static_cast<std::size_t>(grid_.rows().cells));
}

ClosePairs::Pieces ClosePairs::later_pieces(std::int64_t row, std::int64_t column) const {
  Pieces pieces;
  add_own_row(row, column, pieces);
  const GridAxis& rows = grid_.rows();
  const std::int64_t others = grid_.columns().cells - 1;
  const std::int64_t highest = rows.joined ? std::min(row_reach_, rows.cells / 2)
                                           : std::min(row_reach_, rows.cells - 1 - row);
  for (std::int64_t up = 1; up <= highest; ++up) {
    // Half-way round a torus two rows are above each other: one of them takes the pairs.
    if (rows.joined && 2 * up == rows.cells && row >= up) continue;
    const bool wraps = row + up >= rows.cells;
    const std::int64_t other = wraps ? row + up - rows.cells : row + up;
    const std::int64_t reach = column_reach_[static_cast<std::size_t>(up)];
    if (grid_.columns().joined)
      // No cell twice, however far the reach.
      add_row(other, column - std::min(reach, others / 2),
              column + std::min(reach, (others + 1) / 2), wraps, pieces);
    else
      add_row(other, std::max<std::int64_t>(column - reach, 0), std::min(column + reach, others),
              wraps, pieces);
  }
  return pieces;
}

/// From the cell itself, whose points come first, to the right.
void ClosePairs::add_own_row(std::int64_t row, std::int64_t column, Pieces& pieces) const {
  const GridAxis& columns = grid_.columns();
  std::int64_t reach = column_reach_[0];
  if (columns.joined) {
    reach = std::min(reach, columns.cells / 2);
    if (reach > 0 && 2 * reach == columns.cells && column >= reach) --reach;
  } else {
    reach = std::min(reach, columns.cells - 1 - column);
  }
  add_row(row, column, column + reach, false, pieces);
}

void ClosePairs::add_row(std::int64_t row, std::int64_t first, std::int64_t last, bool wraps,
                         Pieces& pieces) const {
  const std::int64_t cells = grid_.columns().cells;
  wraps = wraps || always_wraps_;
  const std::int64_t low = std::max<std::int64_t>(first, 0), high = std::min(last, cells - 1);
  pieces.add(grid_.begin_of(row, low), grid_.end_of(row, high), wraps);
  if (first < 0) pieces.add(grid_.begin_of(row, first + cells), grid_.end_of(row, cells - 1), true);
  if (last >= cells) pieces.add(grid_.begin_of(row, 0), grid_.end_of(row, last - cells), true);
}

double largest_square(double distance) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double square = std::min(distance * distance, std::numeric_limits<double>::max());
  while (std::sqrt(square) > distance) square = std::nextafter(square, 0.0);
  for (double next = square; std::sqrt(next) <= distance; next = std::nextafter(next, infinity))
    square = next;
  return square;
}

DistanceBins::DistanceBins(std::span<const double> distances) {
  PHYTOBENCH_EXPECT(!distances.empty() && distances[0] >= 0.0 && std::isfinite(distances.back()));
  for (std::size_t k = 1; k < distances.size(); ++k)
    PHYTOBENCH_EXPECT(distances[k] > distances[k - 1]);
  for (const double distance : distances) squares_.push_back(largest_square(distance));
  const std::size_t slots = std::clamp<std::size_t>(8 * size(), 64, 1 << 14);
  const double scale = static_cast<double>(slots) / last_square();
  if (std::isfinite(scale)) scale_ = scale;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    // A little below the slot, for the rounding of the product in bin_of().
    const double low = static_cast<double>(slot) / static_cast<double>(slots) * last_square();
    const auto start = std::lower_bound(squares_.begin(), squares_.end(), low * (1.0 - 1e-12));
    starts_.push_back(static_cast<std::size_t>(start - squares_.begin()));
  }
  // Without a scale every square looks into the first slot.
  if (scale_ == 0.0) starts_[0] = 0;
}

std::vector<std::int64_t> close_pair_counts(std::span<const Point2> points, const Window& window,
                                            std::span<const double> distances, int threads) {
  const DistanceBins bins(distances);
  const ClosePairs pairs(points, window, distances.back());
  auto counts = close_pair_sums<std::int64_t>(
      pairs, bins.size(), threads,
      [&bins](std::int64_t* sums, std::size_t, std::size_t, const Point2&, double square) {
        ++sums[bins.bin_of(square)];
      });
  for (std::size_t k = 1; k < counts.size(); ++k) counts[k] += counts[k - 1];
  return counts;
}

}  // namespace phytobench
