// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel/for_blocks.hpp"
#include "core/point_pattern/point_grid.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// All pairs of points at most `reach` apart, found through a cell grid in O(n + pairs) where the
/// density does not vary much. The distance of a pair is sqrt(dx*dx + dy*dy) of
/// Window::difference(), exactly as in a double loop; points at the same place are a pair at
/// distance 0.
class ClosePairs {
 public:
  /// `reach` >= 0 and finite, on a torus below half the shorter side: beyond it a pair would meet
  /// itself from behind. Points as PointGrid expects them.
  ClosePairs(std::span<const Point2> points, const Window& window, double reach);

  /// The pairs come in blocks that depend on the points alone, not on the number of threads.
  std::size_t block_count() const { return block_count_; }

  /// visit(i, j, difference from i to j, squared distance) once for each unordered pair of the
  /// block; i and j are indices of `points`, in no particular order.
  template <class Visit>
  void visit_block(std::size_t block, const Visit& visit) const;

 private:
  struct Piece {
    std::size_t begin, end;
    bool wraps;  // differences may have to go round the torus
  };
  static constexpr std::int64_t steps_ = 3;  // cells per reach: narrow cells waste fewer candidates
  /// The cells of a row that can hold partners, its own cell's first; at most two pieces per row.
  struct Pieces {
    std::array<Piece, 2 * (steps_ + 1)> all;
    std::size_t count = 0;
    void add(std::size_t begin, std::size_t end, bool wraps) {
      if (begin < end) all[count++] = {begin, end, wraps};
    }
  };

  Pieces later_pieces(std::int64_t row, std::int64_t column) const;
  void add_own_row(std::int64_t row, std::int64_t column, Pieces& pieces) const;
  void add_row(std::int64_t row, std::int64_t first, std::int64_t last, bool wraps,
               Pieces& pieces) const;
  template <bool wraps, class Visit>
  void scan(std::size_t i, std::size_t begin, std::size_t end, const Visit& visit) const;

  Window window_;
  PointGrid grid_;
  double limit_;                                         // largest squared distance
  std::int64_t row_reach_;                               // rows upwards
  std::array<std::int64_t, steps_ + 1> column_reach_{};  // to either side, by rows upwards
  bool always_wraps_;  // so few cells that even neighbours may be nearer the other way round
  std::size_t block_count_;
};

/// The largest number whose square root is at most `distance`: comparing squares with it decides as
/// comparing distances does.
double largest_square(double distance);

/// Sorts distances into the steps of an increasing grid of distances.
class DistanceBins {
 public:
  /// Finite, not negative and strictly increasing; at least one.
  explicit DistanceBins(std::span<const double> distances);
  std::size_t size() const { return squares_.size(); }
  double last_square() const { return squares_.back(); }

  /// Number of the first grid distance that is not below the square's root; the square must not
  /// exceed last_square().
  std::size_t bin_of(double square) const {
    const auto slot = static_cast<std::size_t>(square * scale_);
    std::size_t bin = starts_[slot < starts_.size() ? slot : starts_.size() - 1];
    while (square > squares_[bin]) ++bin;
    return bin;
  }

 private:
  std::vector<double> squares_;
  std::vector<std::size_t> starts_;  // lower bounds of the bin, by equal steps of the square
  double scale_ = 0.0;
};

/// Sums over close pairs: visit(sums, i, j, difference, squared distance) adds to the `size` sums
/// of its block. The blocks are added in order, so the result has the same bits for any number of
/// threads.
template <class Number, class Visit>
std::vector<Number> close_pair_sums(const ClosePairs& pairs, std::size_t size, int threads,
                                    const Visit& visit) {
  std::vector<std::vector<Number>> parts(pairs.block_count());
  for_tasks(parts.size(), threads, [&](std::size_t block) {
    std::vector<Number> sums(size, Number{});
    Number* const first = sums.data();
    pairs.visit_block(block,
                      [&visit, first](std::size_t i, std::size_t j, const Point2& difference,
                                      double square) { visit(first, i, j, difference, square); });
    parts[block] = std::move(sums);
  });
  std::vector<Number> totals(size, Number{});
  for (const auto& part : parts)
    for (std::size_t k = 0; k < size; ++k) totals[k] += part[k];
  return totals;
}

/// For each of the increasing distances the number of unordered pairs at most that far apart: a
/// pair at distance d counts at r if d <= r.
std::vector<std::int64_t> close_pair_counts(std::span<const Point2> points, const Window& window,
                                            std::span<const double> distances, int threads = 1);

template <class Visit>
void ClosePairs::visit_block(std::size_t block, const Visit& visit) const {
  const auto rows = static_cast<std::size_t>(grid_.rows().cells);
  const auto end_row = static_cast<std::int64_t>((block + 1) * rows / block_count_);
  for (auto row = static_cast<std::int64_t>(block * rows / block_count_); row < end_row; ++row) {
    for (std::int64_t column = 0; column < grid_.columns().cells; ++column) {
      const std::size_t begin = grid_.begin_of(row, column), end = grid_.end_of(row, column);
      if (begin == end) continue;
      const Pieces pieces = later_pieces(row, column);
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < pieces.count; ++k) {
          const Piece& piece = pieces.all[k];
          const std::size_t first = k == 0 ? i + 1 : piece.begin;
          piece.wraps ? scan<true>(i, first, piece.end, visit)
                      : scan<false>(i, first, piece.end, visit);
        }
      }
    }
  }
}

template <bool wraps, class Visit>
void ClosePairs::scan(std::size_t i, std::size_t begin, std::size_t end, const Visit& visit) const {
  constexpr std::size_t batch = 64;
  const Point2* const points = grid_.points();
  const std::uint32_t* const indices = grid_.indices();
  const Point2 here = points[i];
  std::array<double, batch> squares, dx, dy;
  std::array<std::size_t, batch> near;
  while (begin < end) {
    // Collect without a branch first: whether a candidate is near cannot be predicted.
    const std::size_t stop = end - begin < batch ? end : begin + batch;
    std::size_t count = 0;
    for (; begin < stop; ++begin) {
      const Point2 d = wraps ? window_.difference(here, points[begin]) : points[begin] - here;
      const double square = d.x * d.x + d.y * d.y;
      dx[count] = d.x, dy[count] = d.y;
      squares[count] = square;
      near[count] = begin;
      count += square <= limit_;
    }
    for (std::size_t k = 0; k < count; ++k)
      visit(indices[i], indices[near[k]], Point2{dx[k], dy[k]}, squares[k]);
  }
}

}  // namespace phytobench
