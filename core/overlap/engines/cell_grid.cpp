// SPDX-License-Identifier: MIT
// The grid that most programs have: cells as wide as the largest disc, nine of them looked at. One
// large disc among small ones makes the cells too wide for all.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

class CellGrid {
 public:
  explicit CellGrid(const std::vector<DiscEntry>& entries) : entries_(entries) {
    double largest = 0.0;
    for (const DiscEntry& e : entries) {
      largest = std::max(largest, e.radius);
      low_ = {std::min(low_.x, e.x), std::min(low_.y, e.y)};
      high_ = {std::max(high_.x, e.x), std::max(high_.y, e.y)};
    }
    if (entries.empty()) return;
    // No more cells than discs, however far apart those are.
    const double width = high_.x - low_.x, height = high_.y - low_.y;
    const auto n = static_cast<double>(entries.size());
    edge_ = std::max(
        {2.000002 * largest, std::sqrt(width / n) * std::sqrt(height), width / n, height / n});
    columns_ = place(width) + 1;
    rows_ = place(height) + 1;
    sort_into_cells();
  }

  /// Calls visit(entry) for everything in the cell of `e` and around it.
  template <class Visit>
  void around(const DiscEntry& e, const Visit& visit) const {
    const long column = place(e.x - low_.x), row = place(e.y - low_.y);
    for (long r = std::max(0L, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
      const long first = r * columns_ + std::max(0L, column - 1);
      const long last = r * columns_ + std::min(columns_ - 1, column + 1);
      for (std::size_t k = begin_[static_cast<std::size_t>(first)];
           k < begin_[static_cast<std::size_t>(last) + 1]; ++k)
        visit(entries_[order_[k]]);
    }
  }

 private:
  long place(double offset) const { return static_cast<long>(offset / edge_); }
  std::size_t cell_of(const DiscEntry& e) const {
    return static_cast<std::size_t>(place(e.y - low_.y) * columns_ + place(e.x - low_.x));
  }

  void sort_into_cells() {
    begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const DiscEntry& e : entries_) ++begin_[cell_of(e) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    order_.resize(entries_.size());
    for (std::size_t e = 0; e < entries_.size(); ++e) order_[next[cell_of(entries_[e])]++] = e;
  }

  static constexpr double far = std::numeric_limits<double>::infinity();
  const std::vector<DiscEntry>& entries_;
  Point2 low_{far, far};
  Point2 high_{-far, -far};
  double edge_ = 1.0;
  long columns_ = 0;
  long rows_ = 0;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> order_;
};

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  const CellGrid grid(entries);
  for (const DiscEntry& i : entries) {
    if (i.is_image()) break;  // they follow the discs
    grid.around(i, [&](const DiscEntry& j) {
      if (j.disc > i.disc)
        collector.offer(static_cast<std::size_t>(i.disc), static_cast<std::size_t>(j.disc),
                        j.image);
    });
  }
  collector.work().places = 9 * entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor cell_grid;
constinit const OverlapEngineDescriptor cell_grid{
    .name = "cell_grid",
    .summary = "Looks into nine cells that are as wide as the largest disc.",
    .source = "cell lists, Quentrec and Brot 1973",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
