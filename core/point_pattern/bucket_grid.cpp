// SPDX-License-Identifier: MIT
#include "core/point_pattern/bucket_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

std::uint32_t buckets_along(double length, double side) {
  const double count = std::max(1.0, std::ceil(length / side));
  PHYTOBENCH_EXPECT(count < 0x1p32);
  return static_cast<std::uint32_t>(count);
}

/// How many buckets away a neighbour can be. Never more than a torus or a plain row has.
std::uint32_t reach(double distance, double side, std::uint32_t count) {
  constexpr double rounding = 1.0 + 1e-12;  // points may lie a hair outside of their bucket
  return static_cast<std::uint32_t>(
      std::min(std::floor(distance / side * rounding) + 1.0, static_cast<double>(count)));
}

}  // namespace

BucketGrid::BucketGrid(const Window& window, double side, double distance)
    : goes_round_(window.kind() == WindowKind::torus),
      columns_(buckets_along(window.bounding_box().width(), side)),
      rows_(buckets_along(window.bounding_box().height(), side)),
      size_{window.bounding_box().width() / columns_, window.bounding_box().height() / rows_},
      reach_across_(reach(distance, size_.x, columns_)),
      reach_up_(reach(distance, size_.y, rows_)) {
  const std::uint64_t buckets = std::uint64_t{columns_} * rows_;
  PHYTOBENCH_EXPECT(buckets < none);
  newest_.assign(buckets, none);
}

void BucketGrid::add(const Point2& point, std::uint32_t bucket) {
  PHYTOBENCH_EXPECT(points_.size() < none);
  older_.push_back(newest_[bucket]);
  newest_[bucket] = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
}

BucketGrid::Span BucketGrid::span(std::uint32_t middle, std::uint32_t count,
                                  std::uint32_t reach) const {
  if (2 * std::uint64_t{reach} + 1 >= count) return {0, count};
  if (goes_round_)
    return {middle >= reach ? middle - reach : middle + count - reach, 2 * reach + 1};
  const std::uint32_t first = middle >= reach ? middle - reach : 0;
  return {first, std::min(middle + reach, count - 1) - first + 1};
}

}  // namespace phytobench
