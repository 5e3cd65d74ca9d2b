// SPDX-License-Identifier: MIT
#include "core/geometry/point_tree.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

PointTree::PointTree(std::span<const Point2> points) {
  PHYTOBENCH_EXPECT(points.size() < std::numeric_limits<std::uint32_t>::max());
  while (leaves_ * leaf_size < points.size()) leaves_ *= 2;
  first_leaf_ = leaves_ - 1;
  boxes_.resize(2 * leaves_ - 1);
  std::vector<Numbered> numbered;
  numbered.reserve(points.size());
  for (const Point2& p : points)
    numbered.push_back({p, static_cast<std::uint32_t>(numbered.size())});
  build(0, numbered, 0);
  points_.reserve(points.size());
  index_.reserve(points.size());
  for (const Numbered& n : numbered) {
    points_.push_back(n.point);
    index_.push_back(n.index);
  }
}

void PointTree::build(std::size_t node, std::span<Numbered> part, std::size_t begin) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far},
          {-far, -far},
          static_cast<std::uint32_t>(begin),
          static_cast<std::uint32_t>(begin + part.size())};
  for (const auto& [p, index] : part) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  boxes_[node] = box;
  if (node >= first_leaf_) return;
  const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
  const std::size_t half = part.size() / 2;
  // Equal coordinates by index, so that the tree is the same with every library.
  std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                   [by_x](const Numbered& a, const Numbered& b) {
                     const double x = by_x ? a.point.x : a.point.y;
                     const double y = by_x ? b.point.x : b.point.y;
                     return x != y ? x < y : a.index < b.index;
                   });
  build(2 * node + 1, part.first(half), begin);
  build(2 * node + 2, part.subspan(half), begin + half);
}

}  // namespace phytobench
