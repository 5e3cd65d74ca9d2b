// SPDX-License-Identifier: MIT
#include "reference/oracles/disc_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench::oracles {

namespace {

/// Adds the pair if image (kx, ky) of the later disc overlaps the earlier one.
void add_if_overlapping(std::size_t a, std::size_t b, int kx, int ky,
                        const std::vector<OracleDisc>& discs, const OracleGround& ground,
                        std::vector<OracleOverlap>& found) {
  const std::size_t i = std::min(a, b), j = std::max(a, b);
  const double dx = (discs[j].x - discs[i].x) + kx * ground.period_x;
  const double dy = (discs[j].y - discs[i].y) + ky * ground.period_y;
  const double d = std::sqrt(dx * dx + dy * dy);
  const double large = std::fmax(discs[i].r, discs[j].r), small = std::fmin(discs[i].r, discs[j].r);
  // d < large + small without rounding the sum: where it is close, d - large is exact.
  if (small > 0.0 && d - large < small)
    found.push_back({static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), d});
}

int images_x(const OracleGround& ground) {
  return ground.period_x > 0.0 ? 1 : 0;
}
int images_y(const OracleGround& ground) {
  return ground.period_y > 0.0 ? 1 : 0;
}

void sort(std::vector<OracleOverlap>& found) {
  std::sort(found.begin(), found.end(), [](const OracleOverlap& a, const OracleOverlap& b) {
    return a.i != b.i ? a.i < b.i : a.j != b.j ? a.j < b.j : a.distance < b.distance;
  });
}

/// Centers by square cells as wide as the mean distance between them.
class CenterTable {
 public:
  explicit CenterTable(const std::vector<OracleDisc>& discs) {
    double right = -INFINITY, top = -INFINITY;
    for (const OracleDisc& d : discs) {
      left_ = std::fmin(left_, d.x);
      bottom_ = std::fmin(bottom_, d.y);
      right = std::fmax(right, d.x);
      top = std::fmax(top, d.y);
    }
    const double n = static_cast<double>(discs.size());
    cell_ = std::fmax(std::sqrt((right - left_) / n) * std::sqrt(top - bottom_),
                      std::fmax(right - left_, top - bottom_) / n);
    if (!(cell_ > 0.0)) cell_ = 1.0;
    wide_ = column(right) + 1;
    high_ = row(top) + 1;
    cells_.resize(static_cast<std::size_t>(wide_ * high_));
    for (std::size_t i = 0; i < discs.size(); ++i)
      cells_[static_cast<std::size_t>(row(discs[i].y) * wide_ + column(discs[i].x))].push_back(i);
  }

  /// Calls visit for all centers within `reach` of (x, y) along both axes, and some beyond.
  template <class Visit>
  void within(double x, double y, double reach, const Visit& visit) const {
    for (long r = std::max(0L, row(y - reach) - 1); r <= std::min(high_ - 1, row(y + reach) + 1);
         ++r)
      for (long c = std::max(0L, column(x - reach) - 1);
           c <= std::min(wide_ - 1, column(x + reach) + 1); ++c)
        for (const std::size_t i : cells_[static_cast<std::size_t>(r * wide_ + c)]) visit(i);
  }

 private:
  static long clamped(double place) {
    return static_cast<long>(std::fmax(-2.0, std::fmin(place, 4e9)));
  }
  long column(double x) const { return clamped(std::floor((x - left_) / cell_)); }
  long row(double y) const { return clamped(std::floor((y - bottom_) / cell_)); }

  double left_ = INFINITY, bottom_ = INFINITY, cell_ = 1.0;
  long wide_ = 0, high_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<OracleOverlap> overlaps_literally(const std::vector<OracleDisc>& discs,
                                              const OracleGround& ground) {
  std::vector<OracleOverlap> found;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      for (int ky = -images_y(ground); ky <= images_y(ground); ++ky)
        for (int kx = -images_x(ground); kx <= images_x(ground); ++kx)
          add_if_overlapping(i, j, kx, ky, discs, ground, found);
  sort(found);
  return found;
}

std::vector<OracleOverlap> overlaps_by_table(const std::vector<OracleDisc>& discs,
                                             const OracleGround& ground) {
  std::vector<OracleOverlap> found;
  if (discs.empty()) return found;
  const CenterTable table(discs);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const OracleDisc& large = discs[i];
    for (int ky = -images_y(ground); ky <= images_y(ground); ++ky) {
      for (int kx = -images_x(ground); kx <= images_x(ground); ++kx) {
        const double x = large.x - kx * ground.period_x, y = large.y - ky * ground.period_y;
        table.within(x, y, 2.0 * large.r, [&](std::size_t j) {
          const bool is_larger = discs[j].r < large.r || (discs[j].r == large.r && i < j);
          if (!is_larger) return;
          // Seen from the earlier disc the image lies the other way where that is the smaller.
          const int turn = i < j ? 1 : -1;
          add_if_overlapping(i, j, turn * kx, turn * ky, discs, ground, found);
        });
      }
    }
  }
  sort(found);
  return found;
}

std::vector<OracleOverlap> overlaps_of(std::size_t disc, const std::vector<OracleDisc>& discs,
                                       const OracleGround& ground) {
  std::vector<OracleOverlap> found;
  for (std::size_t j = 0; j < discs.size(); ++j)
    for (int ky = -images_y(ground); j != disc && ky <= images_y(ground); ++ky)
      for (int kx = -images_x(ground); kx <= images_x(ground); ++kx)
        add_if_overlapping(disc, j, kx, ky, discs, ground, found);
  sort(found);
  return found;
}

}  // namespace phytobench::oracles
