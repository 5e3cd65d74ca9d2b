// SPDX-License-Identifier: MIT
#include "core/overlap/candidate_pairs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/overlap/lens.hpp"

namespace phytobench {

void refuse_more_pairs(std::size_t most_pairs) {
  throw InputError(fmt::format(
      "more than {} pairs of discs overlap; are many at one place, or radii in another unit than "
      "coordinates?",
      most_pairs));
}

void PairCollector::flush() {
  const auto part = [this](auto& array) { return std::span(array).first(waiting_); };
  lens_areas(part(r_), part(s_), part(distance_), part(area_));
  pairs_.make_room(waiting_);
  DiscIndex *first = pairs_.first_end(), *second = pairs_.second_end();
  double* area = pairs_.area_end();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < waiting_; ++i) {
    first[kept] = first_[i];
    second[kept] = second_[i];
    area[kept] = area_[i];
    kept += area_[i] > 0.0;
  }
  pairs_.add_written(kept);
  waiting_ = 0;
  if (pairs_.size() > most_pairs_) refuse_more_pairs(most_pairs_);
}

std::vector<DiscEntry> entries_with_images(const Discs& discs, const Ground& ground) {
  std::vector<DiscEntry> entries;
  entries.reserve(discs.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (discs.radius[i] <= 0.0) continue;
    entries.push_back({discs.x[i], discs.y[i], discs.radius[i], static_cast<DiscIndex>(i), {}});
    largest = std::max(largest, discs.radius[i]);
  }
  if (!ground.torus) return entries;
  const Rectangle& window = *ground.torus;
  const std::size_t originals = entries.size();
  for (std::size_t e = 0; e < originals; ++e) {
    const DiscEntry original = entries[e];
    // Generous: whether they really meet is decided by the distance that all engines share.
    const double reach = 1.000001 * (original.radius + largest);
    for (int ky = -1; ky <= 1; ++ky) {
      for (int kx = -1; kx <= 1; ++kx) {
        const Point2 p{original.x + kx * window.width(), original.y + ky * window.height()};
        const bool near = p.x >= window.low.x - reach && p.x <= window.high.x + reach &&
                          p.y >= window.low.y - reach && p.y <= window.high.y + reach;
        if (near && (kx != 0 || ky != 0))
          entries.push_back({p.x, p.y, original.radius, original.disc, {kx, ky}});
      }
    }
  }
  return entries;
}

}  // namespace phytobench
