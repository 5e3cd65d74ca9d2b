// SPDX-License-Identifier: MIT
#include "core/colonization/attraction_cloud.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

namespace {

/// Lowest and highest y of the cut unit sphere.
struct UnitPlanes {
  double bottom;
  double top;
};

UnitPlanes planes(double cutoff_bottom, double cutoff_top) {
  return {-1.0 + 2.0 * cutoff_bottom, 1.0 - 2.0 * cutoff_top};
}

/// One point of the cut unit sphere. A height outside the planes restarts before x and z are drawn.
Vector3 point_in_unit_segment(const UnitPlanes& cut, UnitStream& stream) {
  for (;;) {
    const double y = stream.next_between(-1.0, 1.0);
    if (y < cut.bottom || y > cut.top) continue;
    const double x = stream.next_between(-1.0, 1.0);
    const double z = stream.next_between(-1.0, 1.0);
    const Vector3 point{x, y, z};
    if (squared_norm(point) <= 1.0) return point;
  }
}

}  // namespace

double unit_segment_volume(double cutoff_bottom, double cutoff_top) {
  PHYTOBENCH_EXPECT(cutoff_bottom >= 0.0 && cutoff_top >= 0.0 && cutoff_bottom + cutoff_top < 1.0);
  const auto [a, b] = planes(cutoff_bottom, cutoff_top);
  return std::numbers::pi * ((b - b * b * b / 3.0) - (a - a * a * a / 3.0));
}

double volume(const CutEllipsoid& shape) {
  const double determinant = shape.radii.x * shape.radii.y * shape.radii.z;
  return determinant * unit_segment_volume(shape.cutoff_bottom, shape.cutoff_top);
}

std::size_t attraction_point_count(const CutEllipsoid& shape, double density) {
  const double count = std::ceil(volume(shape) * density);
  constexpr double most = std::numeric_limits<PointIndex>::max();
  if (!(count <= most))
    throw InputError(
        fmt::format("cloud.density asks for {:.4g} attraction points, more than the {:.4g} an "
                    "index can count; lower "
                    "cloud.density or the cloud radii",
                    count, most));
  return static_cast<std::size_t>(count);
}

std::vector<Vector3> attraction_points(const CutEllipsoid& shape, std::size_t count,
                                       const Vector3& crown_root, UnitStream& stream) {
  const UnitPlanes cut = planes(shape.cutoff_bottom, shape.cutoff_top);
  const double lift = shape.radii.y - 2.0 * shape.radii.y * shape.cutoff_bottom;
  const Vector3 centre = crown_root + Vector3{0.0, lift, 0.0};
  std::vector<Vector3> points;
  points.reserve(count);
  while (points.size() < count)
    points.push_back(centre + hadamard_product(shape.radii, point_in_unit_segment(cut, stream)));
  return points;
}

BoundingBox extent_of(const std::vector<Vector3>& points) {
  BoundingBox box;
  for (const Vector3& point : points) box.extend(point);
  return box;
}

}  // namespace phytobench
