// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "core/geometry/vector3.hpp"

namespace phytobench {

/// Axis-parallel box; empty until the first point. [Brzoska2019] sec. 5.2.2 keeps six extrema of
/// all nodes and updates them with every new node.
class BoundingBox {
 public:
  void extend(const Vector3& point) {
    low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y), std::min(low_.z, point.z)};
    high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y), std::max(high_.z, point.z)};
  }

  /// The same box moved outwards by `margin` on all six sides. Rounded outwards by one unit in the
  /// last place, so that a point exactly at the margin is never lost.
  BoundingBox widened(double margin) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto down = [](double value) { return std::nextafter(value, -infinity); };
    const auto up = [](double value) { return std::nextafter(value, infinity); };
    margin *= 1.0 + 0x1p-40;
    BoundingBox box;
    box.low_ = {down(low_.x - margin), down(low_.y - margin), down(low_.z - margin)};
    box.high_ = {up(high_.x + margin), up(high_.y + margin), up(high_.z + margin)};
    return box;
  }

  bool contains(const Vector3& point) const {
    return point.x >= low_.x && point.x <= high_.x && point.y >= low_.y && point.y <= high_.y &&
           point.z >= low_.z && point.z <= high_.z;
  }

  bool empty() const { return low_.x > high_.x; }
  const Vector3& low() const { return low_; }
  const Vector3& high() const { return high_; }
  Vector3 extent() const { return empty() ? Vector3{} : high_ - low_; }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  Vector3 low_{far, far, far};
  Vector3 high_{-far, -far, -far};
};

}  // namespace phytobench
