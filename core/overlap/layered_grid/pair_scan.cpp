// SPDX-License-Identifier: MIT
#include "core/overlap/layered_grid/pair_scan.hpp"

#include <algorithm>
#include <cmath>

#include "core/overlap/candidate_pairs.hpp"
#include "core/overlap/lens.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/overlap/layered_grid/pair_scan.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;

/// Columns that lie side by side in memory, and what to add to their discs' coordinates: periods.
struct Run {
  std::size_t begin, end;
  Point2 shift;
};

class PairScan {
 public:
  PairScan(const PairScanJob& job, OverlapPairs& pairs)
      : job_(job),
        grid_(*job.grid),
        layer_(grid_.layers()[job.layer]),
        low_(grid_.low()),
        period_(grid_.period()),
        is_torus_(period_.x > 0.0),
        cell_begin_(grid_.cell_begin()),
        x_(grid_.x()),
        y_(grid_.y()),
        radius_(grid_.radius()),
        disc_(grid_.disc()),
        pairs_(pairs) {}

  OverlapWork run() {
    for (std::int32_t row = job_.first_row; row < job_.end_row; ++row) scan_row(row);
    flush();
    return work_;
  }

 private:
  /// How often cell `c` of a ring of `count` lies round it: below 0 backwards.
  static std::int64_t turns_of(std::int64_t c, std::int64_t count) {
    return c >= 0 ? c / count : -((count - 1 - c) / count);
  }

  const std::uint32_t* cells_of(const DiscLayer& layer, std::int64_t row) const {
    return cell_begin_ + layer.first_cell +
           static_cast<std::size_t>(row) * static_cast<std::size_t>(layer.columns);
  }

  /// Calls visit(run) for the cells first ... last of a row, which go round on a torus and end at
  /// the border elsewhere.
  template <class Visit>
  HWY_INLINE void for_runs(const DiscLayer& layer, std::int64_t row, std::int64_t first,
                           std::int64_t last, const Visit& visit) const {
    const std::int64_t columns = layer.columns;
    Point2 shift;
    if (row < 0 || row >= layer.rows) {
      if (!is_torus_) return;
      const std::int64_t turns = turns_of(row, layer.rows);
      row -= turns * layer.rows;
      shift.y = static_cast<double>(turns) * period_.y;
    }
    const std::uint32_t* cells = cells_of(layer, row);
    const auto cell = [&](std::int64_t c) { return std::size_t{cells[c]}; };
    if (first >= 0 && last < columns) {
      visit(Run{cell(first), cell(last + 1), shift});
      return;
    }
    if (!is_torus_) {
      visit(Run{cell(std::max<std::int64_t>(first, 0)), cell(std::min(last + 1, columns)), shift});
      return;
    }
    for (std::int64_t c = first; c <= last;) {
      const std::int64_t turns = turns_of(c, columns);
      const std::int64_t end = std::min(last + 1, (turns + 1) * columns);
      shift.x = static_cast<double>(turns) * period_.x;
      visit(Run{cell(c - turns * columns), cell(end - turns * columns), shift});
      c = end;
    }
  }

  HWY_INLINE void scan_row(std::int32_t row) {
    const std::uint32_t* cells = cells_of(layer_, row);
    for (std::int32_t column = 0; column < layer_.columns; ++column) {
      const std::size_t begin = cells[column], end = cells[column + 1];
      if (begin == end) continue;
      scan_own_layer(row, column, begin, end);
      for (std::size_t finer = job_.layer + 1; finer < grid_.layers().size(); ++finer)
        for (std::size_t i = begin; i < end; ++i) scan_finer_layer(grid_.layers()[finer], i);
    }
  }

  /// Half of the nine cells: the other half has its turn with its own discs.
  HWY_INLINE void scan_own_layer(std::int32_t row, std::int32_t column, std::size_t begin,
                                 std::size_t end) {
    Run runs[6];
    int count = 0;
    const auto add = [&](const Run& run) { runs[count++] = run; };
    std::size_t own_end = end;
    if (column + 1 < layer_.columns)
      own_end = cells_of(layer_, row)[column + 2];
    else
      for_runs(layer_, row, column + 1, column + 1, add);
    for_runs(layer_, row + 1, column - 1, column + 1, add);
    for (std::size_t i = begin; i < end; ++i) {
      const Disc disc = disc_at(i);
      scan_run(disc, {i + 1, own_end, {}});
      for (int r = 0; r < count; ++r) scan_run(disc, runs[r]);
    }
  }

  /// All cells of the layer's rows that the circle of disc i, widened by the largest disc there,
  /// reaches.
  HWY_INLINE void scan_finer_layer(const DiscLayer& layer, std::size_t i) {
    // A little more, for what is rounded on the way to a cell's number.
    const double reach = (radius_[i] + layer.largest_radius) * (1.0 + 1e-6);
    const double x = x_[i] - low_.x, y = y_[i] - low_.y;
    const Disc disc = disc_at(i);
    // One beyond the border is enough on the plane; reach may be a number of heights without end.
    const double turns = is_torus_ ? 3.0 : 0.0;
    const auto cell = [turns](double offset, double per_unit, std::int32_t count) {
      return static_cast<std::int64_t>(
          std::clamp(std::floor(offset * per_unit), -1.0 - turns * count, (1.0 + turns) * count));
    };
    const std::int64_t first = cell(y - reach, layer.cells_per_y, layer.rows);
    const std::int64_t last = cell(y + reach, layer.cells_per_y, layer.rows);
    const std::int64_t from = is_torus_ ? first : std::max<std::int64_t>(first, 0);
    const std::int64_t to = is_torus_ ? last : std::min<std::int64_t>(last, layer.rows - 1);
    for (std::int64_t row = from; row <= to; ++row) {
      const double half = half_chord(layer, static_cast<double>(row), y, reach);
      if (half < 0.0) continue;
      for_runs(layer, row, cell(x - half, layer.cells_per_x, layer.columns),
               cell(x + half, layer.cells_per_x, layer.columns),
               [&](const Run& run) { scan_run(disc, run); });
    }
  }

  /// Half of what a circle of radius `reach` at height y cuts from a row of cells at most.
  static double half_chord(const DiscLayer& layer, double row, double y, double reach) {
    if (!(layer.cells_per_y > 0.0)) return reach;
    const double below = row / layer.cells_per_y - y, above = (row + 1.0) / layer.cells_per_y - y;
    const double off = std::max({0.0, below, -above}) * (1.0 - 1e-6);
    return std::sqrt(std::max(0.0, reach * reach - off * off));
  }

  /// One disc, in every lane.
  struct Disc {
    hn::Vec<Tag> x, y, radius, disc;
  };
  HWY_INLINE Disc disc_at(std::size_t i) const {
    const Tag d;
    return {hn::Set(d, x_[i]), hn::Set(d, y_[i]), hn::Set(d, radius_[i]), hn::Set(d, disc_[i])};
  }

  /// Notes which discs of the run may overlap disc `i`.
  HWY_INLINE void scan_run(const Disc& i, const Run& run) {
    const Tag d;
    const std::size_t lanes = hn::Lanes(d);
    const auto shift_x = hn::Set(d, run.shift.x), shift_y = hn::Set(d, run.shift.y);
    const auto margin = hn::Set(d, squared_margin);
    work_.candidates += run.end > run.begin ? run.end - run.begin : 0;
    for (std::size_t j = run.begin; j < run.end; j += lanes) {
      const auto dx = hn::Add(hn::Sub(hn::LoadU(d, x_ + j), i.x), shift_x);
      const auto dy = hn::Add(hn::Sub(hn::LoadU(d, y_ + j), i.y), shift_y);
      const auto s = hn::LoadU(d, radius_ + j);
      const auto squared = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
      const auto sum = hn::Add(i.radius, s);
      const auto near = hn::Le(squared, hn::Mul(hn::Mul(sum, sum), margin));
      const auto hits = hn::And(near, hn::FirstN(d, run.end - j));
      if (waiting_ + lanes > batch) flush();
      hn::StoreU(i.radius, d, r_ + waiting_);
      hn::StoreU(i.disc, d, first_ + waiting_);
      hn::CompressStore(squared, hits, d, distance_ + waiting_);
      hn::CompressStore(s, hits, d, s_ + waiting_);
      waiting_ += hn::CompressStore(hn::LoadU(d, disc_ + j), hits, d, second_ + waiting_);
    }
  }

  /// Distances, areas, and out.
  HWY_NOINLINE void flush() {
    const Tag d;
    for (std::size_t p = 0; p < waiting_; p += hn::Lanes(d))
      hn::Store(hn::Sqrt(hn::Load(d, distance_ + p)), d, distance_ + p);
    lens_areas({r_, waiting_}, {s_, waiting_}, {distance_, waiting_}, {area_, waiting_});
    const std::size_t kept = drop_touching();
    pairs_.make_room(kept + most_lanes);
    write_out(kept);
    pairs_.add_written(kept);
    waiting_ = 0;
    if (job_.pairs_so_far->fetch_add(kept, std::memory_order_relaxed) + kept > job_.most_pairs)
      refuse_more_pairs(job_.most_pairs);
  }

  /// Closes the gaps of those that have no area in common: hardly any. How many are left.
  HWY_INLINE std::size_t drop_touching() {
    std::size_t kept = 0;
    while (kept < waiting_ && area_[kept] > 0.0) ++kept;
    for (std::size_t p = kept; p < waiting_; ++p) {
      first_[kept] = first_[p];
      second_[kept] = second_[p];
      area_[kept] = area_[p];
      kept += area_[p] > 0.0;
    }
    return kept;
  }

  /// Writes up to a vector more than `count`.
  HWY_INLINE void write_out(std::size_t count) {
    const Tag d;
    const hn::Rebind<DiscIndex, Tag> index;
    DiscIndex *first = pairs_.first_end(), *second = pairs_.second_end();
    double* area = pairs_.area_end();
    for (std::size_t p = 0; p < count; p += hn::Lanes(d)) {
      const auto i = hn::DemoteTo(index, hn::Load(d, first_ + p));
      const auto j = hn::DemoteTo(index, hn::Load(d, second_ + p));
      hn::StoreU(hn::Min(i, j), index, first + p);
      hn::StoreU(hn::Max(i, j), index, second + p);
      hn::StoreU(hn::Load(d, area_ + p), d, area + p);
    }
  }

  static constexpr std::size_t batch = 512;
  static constexpr std::size_t most_lanes = 16;  ///< of any target, so that all ask for one room
  static_assert(HWY_MAX_BYTES / sizeof(double) <= most_lanes);
  /// Some roundings above (r + s)^2: only the lens decides what touches.
  static constexpr double squared_margin = 1.0 + 0x1p-48;

  const PairScanJob& job_;
  const LayeredGrid& grid_;
  const DiscLayer& layer_;
  Point2 low_, period_;
  bool is_torus_;
  const std::uint32_t* cell_begin_;
  const double *x_, *y_, *radius_, *disc_;
  OverlapPairs& pairs_;
  OverlapWork work_;
  std::size_t waiting_ = 0;
  /// Written and read by whole vectors, which may reach beyond the last pair.
  template <class T>
  using Batch = T[batch + 16];
  alignas(64) Batch<double> r_{}, s_{}, distance_{}, area_{}, first_{}, second_{};
};

void scan(const PairScanJob& job, OverlapPairs& pairs, OverlapWork& work) {
  work = PairScan(job, pairs).run();
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

namespace {
HWY_EXPORT(scan);
}

OverlapWork scan_pairs(const PairScanJob& job, OverlapPairs& pairs) {
  OverlapWork work;
  HWY_DYNAMIC_DISPATCH(scan)(job, pairs, work);
  return work;
}

}  // namespace phytobench
#endif
