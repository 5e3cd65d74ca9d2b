// SPDX-License-Identifier: MIT
#include "core/point_pattern/point_tree.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract/check.hpp"

namespace phytobench {

PointTree::PointTree(std::span<const Point2> points) : index_(points.size()) {
  PHYTOBENCH_EXPECT(points.size() < std::numeric_limits<std::uint32_t>::max());
  while (leaves_ * leaf_size < points.size()) leaves_ *= 2;
  first_leaf_ = leaves_ - 1;
  boxes_.resize(2 * leaves_ - 1);
  std::iota(index_.begin(), index_.end(), std::uint32_t{0});
  points_.assign(points.begin(), points.end());
  build(0, 0, points.size(), points);
  for (std::size_t place = 0; place < points.size(); ++place)
    points_[place] = points[index_[place]];
}

void PointTree::build(std::size_t node, std::size_t begin, std::size_t end,
                      std::span<const Point2> points) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{
      {far, far}, {-far, -far}, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  for (std::size_t place = begin; place < end; ++place) {
    const Point2& p = points[index_[place]];
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  boxes_[node] = box;
  if (node >= first_leaf_) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
  const auto at = [this](std::size_t place) {
    return index_.begin() + static_cast<std::ptrdiff_t>(place);
  };
  // Equal coordinates by index, so that the tree is the same with every library.
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    const double x = by_x ? points[a].x : points[a].y, y = by_x ? points[b].x : points[b].y;
    return x != y ? x < y : a < b;
  });
  build(2 * node + 1, begin, middle, points);
  build(2 * node + 2, middle, end, points);
}

}  // namespace phytobench
