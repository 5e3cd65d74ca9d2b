// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/branch_mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/regression/checks/expected_rings.hpp"
#include "benchmarks/regression/checks/tube_check.hpp"
#include "core/contract/check.hpp"
#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench {

namespace {

namespace paper = oracles::brzoska2019;
using paper::Point;

constexpr double ring_rounding = 1e-9;

/// v turned by the smallest rotation that takes one unit vector to another.
Point carried(const Point& v, const Point& from, const Point& to) {
  const Point axis = vector_product(from, to);
  const double sine = length(axis);
  if (sine == 0.0) return v;
  return rotated(v, over(axis, sine), std::atan2(sine, scalar_product(from, to)));
}

class BranchMeshCheck {
 public:
  BranchMeshCheck(const BranchMesh& branches, const ExpectedRings& expected,
                  const BranchMeshOptions& options)
      : mesh_(branches.mesh),
        duplicated_(branches.duplicated_rings),
        options_(options),
        expected_(expected),
        at_(mesh_, expected, options.circle_resolution),
        corners_(static_cast<std::size_t>(options.circle_resolution)) {}

  std::string run() const {
    for (const auto check :
         {&BranchMeshCheck::counts, &BranchMeshCheck::rings, &BranchMeshCheck::texture})
      if (std::string wrong = (this->*check)(); !wrong.empty()) return wrong;
    return {};
  }

 private:
  std::string counts() const {
    const std::size_t vertices = (corners_ + 1) * expected_.rings.size();
    struct Count {
      const char* what;
      std::size_t found, expected;
    };
    for (const auto& [what, found, expected] :
         {Count{"duplicated rings", duplicated_, expected_.duplicated},
          Count{"vertices of branches", mesh_.vertex_count(), vertices},
          Count{"normals of branches", mesh_.normals.size(), vertices},
          Count{"texture points of branches", mesh_.texture_points.size(), vertices},
          Count{"triangles of branches", mesh_.triangle_count(),
                2 * corners_ * (expected_.below.size() - 1)}})
      if (found != expected) return fmt::format("{} {} instead of {}", found, what, expected);
    for (const Triangle& triangle : mesh_.triangles)
      if (*std::max_element(triangle.begin(), triangle.end()) >= vertices)
        return "a triangle of a branch has a vertex that is not there";
    return {};
  }

  /// Where the first corner of a ring lies, seen from its center.
  Point first_corner(std::size_t k) const {
    const ExpectedRing& ring = expected_.rings[k];
    const std::size_t from = ring.turned_from;
    if (k == 0 || options_.ring_turn == RingTurn::from_vertical)
      return paper::equation_3_corrected({1.0, 0.0, 0.0}, ring.looks);
    const Point below = expected_.rings[from].looks;
    constexpr double nearly_back = -0.9986;  // cosine of 177 degrees
    if (scalar_product(below, ring.looks) < nearly_back) return at_.outward(at_.first_vertex(k));
    return carried(at_.outward(at_.first_vertex(from)), below, ring.looks);
  }

  std::string rings() const {
    for (std::size_t k = 0; k < expected_.rings.size(); ++k) {
      const Point first = first_corner(k);
      for (std::size_t i = 0; i <= corners_; ++i)
        if (const std::string_view wrong = wrong_with_corner(k, i, first); !wrong.empty())
          return fmt::format("vertex {}, corner {} of ring {}: {}", at_.first_vertex(k) + i, i, k,
                             wrong);
      if (mesh_.positions[at_.first_vertex(k)] != mesh_.positions[at_.first_vertex(k) + corners_])
        return fmt::format("ring {} is open at its seam", k);
    }
    return {};
  }

  std::string_view wrong_with_corner(std::size_t k, std::size_t i, const Point& first) const {
    const Point& looks = expected_.rings[k].looks;
    const Point found = at_.outward(at_.first_vertex(k) + i);
    if (!(std::abs(length(found) - 1.0) <= ring_rounding))
      return "not at the radius from the center";
    if (!(std::abs(scalar_product(found, looks)) <= ring_rounding))
      return "not in the ring's plane";
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(i) / options_.circle_resolution;
    const Point expected =
        plus(times(std::cos(turn), first), times(std::sin(turn), vector_product(first, looks)));
    return length(minus(found, expected)) <= ring_rounding ? "" : "turned away from its place";
  }

  std::string texture() const {
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const TexturePoint& found = mesh_.texture_points[v];
      const double u = static_cast<double>(at_.corner_of(v)) / static_cast<double>(corners_);
      const double height = expected_.rings[at_.ring_of(v)].height / options_.texture_length;
      if (!(std::abs(found.u - u) <= ring_rounding) ||
          !(std::abs(found.v - height) <= ring_rounding * std::max(1.0, height)))
        return fmt::format("vertex {}: texture point ({:.17g}, {:.17g}) instead of ({}, {})", v,
                           found.u, found.v, u, height);
    }
    return {};
  }

  const TriangleMesh& mesh_;
  std::size_t duplicated_;
  const BranchMeshOptions& options_;
  const ExpectedRings& expected_;
  MeshRings at_;
  std::size_t corners_;
};

}  // namespace

std::string objection_to_branch_mesh(const BranchMesh& branches, const Skeleton& skeleton,
                                     std::span<const double> radii,
                                     const BranchMeshOptions& options) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count() && options.circle_resolution >= 3);
  const ExpectedRings expected = expected_rings(skeleton, radii, options);
  const std::string wrong = BranchMeshCheck(branches, expected, options).run();
  if (!wrong.empty()) return wrong;
  return objection_to_tubes(branches.mesh, expected, options.circle_resolution);
}

}  // namespace phytobench
