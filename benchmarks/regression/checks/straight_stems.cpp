// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/straight_stems.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace phytobench {

namespace {

constexpr double stem_rounding = 1e-12;

}  // namespace

StraightStems::StraightStems(const TriangleMesh& mesh, const Stem& stem, std::size_t count)
    : mesh_(mesh),
      stem_(stem),
      count_(count),
      segments_(static_cast<std::size_t>(stem.segments)),
      corners_(static_cast<std::size_t>(stem.corners)) {}

std::string StraightStems::objection() const {
  const std::size_t vertices = count_ * (segments_ + 1) * (corners_ + 1);
  const std::size_t triangles = count_ * segments_ * corners_ * 2;
  if (mesh_.positions.size() != vertices || mesh_.normals.size() != vertices ||
      mesh_.triangles.size() != triangles)
    return fmt::format("{} vertices and {} triangles instead of {} and {}", mesh_.positions.size(),
                       mesh_.triangles.size(), vertices, triangles);
  for (std::size_t i = 0; i < count_; ++i) {
    std::string wrong = objection_to_rings(i);
    if (wrong.empty()) wrong = objection_to_triangles(i);
    if (!wrong.empty()) return fmt::format("stem {}: {}", i, wrong);
  }
  return "";
}

Vector3 StraightStems::direction(std::size_t i) const {
  const Vector3 along = tip(i) - base(i);
  return along / norm(along);
}

std::size_t StraightStems::vertex(std::size_t i, std::size_t ring, std::size_t corner) const {
  return (i * (segments_ + 1) + ring) * (corners_ + 1) + corner;
}

Vector3 StraightStems::center(std::size_t i, std::size_t ring) const {
  Vector3 sum;
  for (std::size_t corner = 0; corner < corners_; ++corner)
    sum = sum + mesh_.positions[vertex(i, ring, corner)];
  return sum / static_cast<double>(corners_);
}

double StraightStems::radius(std::size_t ring) const {
  const double share = static_cast<double>(ring) / static_cast<double>(segments_);
  return stem_.radius_first + share * (stem_.radius_last - stem_.radius_first);
}

std::string StraightStems::objection_to_rings(std::size_t i) const {
  const Vector3 from = base(i), along = tip(i) - from;
  if (!(std::abs(norm(along) - stem_.length) <= 10.0 * stem_rounding)) return "has another length";
  for (std::size_t ring = 0; ring <= segments_; ++ring) {
    const double share = static_cast<double>(ring) / static_cast<double>(segments_);
    const Vector3 middle = from + share * along;
    for (std::size_t corner = 0; corner <= corners_; ++corner) {
      const std::size_t v = vertex(i, ring, corner);
      const Vector3 out = mesh_.positions[v] - middle;
      if (!(std::abs(norm(out) - radius(ring)) <= 10.0 * stem_rounding))
        return "has another radius";
      if (!(std::abs(dot(out, along)) <= 10.0 * stem_rounding)) return "a ring stands askew";
      if (!(std::abs(norm(mesh_.normals[v]) - 1.0) <= 10.0 * stem_rounding)) return "an odd normal";
      if (!(dot(mesh_.normals[v], out) > 0.0)) return "a normal looks inwards";
    }
    if (!(mesh_.positions[vertex(i, ring, 0)] == mesh_.positions[vertex(i, ring, corners_)]))
      return "a ring is open";
  }
  return "";
}

/// Between two rings each quadrilateral is cut into two: so many different triangles, all within
/// one of them and all outwards, are all of the surface.
std::string StraightStems::objection_to_triangles(std::size_t i) const {
  const std::size_t each = segments_ * corners_ * 2, first = vertex(i, 0, 0);
  const Vector3 from = base(i), along = direction(i);
  std::set<Triangle> seen;
  for (std::size_t t = i * each; t < (i + 1) * each; ++t) {
    Triangle triangle = mesh_.triangles[t];
    const Vector3 a = mesh_.positions[triangle[0]], b = mesh_.positions[triangle[1]],
                  c = mesh_.positions[triangle[2]];
    const Vector3 middle = (a + b + c) / 3.0 - from;
    if (!(dot(cross(b - a, c - a), middle - dot(middle, along) * along) > 0.0))
      return "a triangle does not look outwards";
    std::sort(triangle.begin(), triangle.end());
    if (!seen.insert(triangle).second) return "a triangle is there twice";
    if (triangle[0] < first || triangle[2] > vertex(i, segments_, corners_))
      return "a triangle belongs elsewhere";
    const std::size_t low = triangle[0] - first, high = triangle[2] - first;
    const std::size_t width = corners_ + 1;
    if (high / width != low / width + 1) return "a triangle leaves its two rings";
    for (const std::uint32_t corner : triangle) {
      const std::size_t place = (corner - first) % width;
      if (place != low % width && place != low % width + 1 && place + 1 != low % width)
        return "a triangle leaves its side";
    }
  }
  return "";
}

}  // namespace phytobench
