// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/tube_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "reference/oracles/brzoska2019_missing_cases.hpp"

namespace phytobench {

namespace {

namespace paper = oracles::brzoska2019;
using paper::Point;

constexpr double tube_rounding = 1e-9;

/// Corner numbers as if the seam of each ring were sewn up.
using TriangleCorners = std::array<int, 3>;

class TubeCheck {
 public:
  TubeCheck(const TriangleMesh& mesh, const ExpectedRings& expected, int corners)
      : mesh_(mesh),
        expected_(expected),
        at_(mesh, expected, corners),
        corners_(static_cast<std::size_t>(corners)),
        nodes_(expected.below.size()) {}

  std::string run() const {
    for (const auto check :
         {&TubeCheck::triangles, &TubeCheck::open_sides, &TubeCheck::facing, &TubeCheck::normals})
      if (std::string wrong = (this->*check)(); !wrong.empty()) return wrong;
    return {};
  }

 private:
  TriangleCorners sewn_up(const Triangle& triangle) const {
    TriangleCorners corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = static_cast<int>(at_.ring_of(triangle[k]) * corners_ +
                                    at_.corner_of(triangle[k]) % corners_);
    return corners;
  }

  /// Those of a tube for every node but the root, wherever they stand in the list.
  std::vector<TriangleCorners> expected_triangles() const {
    const int w = static_cast<int>(corners_);
    std::vector<TriangleCorners> all;
    for (std::size_t node = 1; node < nodes_; ++node)
      for (TriangleCorners tube : paper::triangles_of_tube(w, 2)) {
        for (int& corner : tube)
          corner = corner < w ? static_cast<int>(expected_.below[node]) * w + corner
                              : static_cast<int>(node) * w + corner - w;
        std::sort(tube.begin(), tube.end());
        all.push_back(tube);
      }
    std::sort(all.begin(), all.end());
    return all;
  }

  std::string triangles() const {
    std::vector<TriangleCorners> found;
    for (const Triangle& triangle : mesh_.triangles) {
      const auto [least, most] = std::minmax(
          {at_.corner_of(triangle[0]), at_.corner_of(triangle[1]), at_.corner_of(triangle[2])});
      if (most - least > 1) return "a triangle goes round a ring across its seam";
      found.push_back(sewn_up(triangle));
      std::sort(found.back().begin(), found.back().end());
    }
    std::sort(found.begin(), found.end());
    const std::vector<TriangleCorners> expected = expected_triangles();
    const auto [one, other] = std::mismatch(expected.begin(), expected.end(), found.begin());
    if (one == expected.end()) return {};
    return fmt::format("triangles are not those of tubes: ({}, {}, {}) instead of ({}, {}, {})",
                       (*other)[0], (*other)[1], (*other)[2], (*one)[0], (*one)[1], (*one)[2]);
  }

  std::string open_sides() const {
    std::vector<TriangleCorners> all;
    for (const Triangle& triangle : mesh_.triangles) all.push_back(sewn_up(triangle));
    const auto found = static_cast<std::size_t>(paper::open_sides(all));
    const std::size_t expected = corners_ * expected_.open_rings();
    if (found == expected) return {};
    return fmt::format("{} sides belong to one triangle only instead of {}", found, expected);
  }

  Point normal_of(const Triangle& t) const {
    return vector_product(minus(at_.place(t[1]), at_.place(t[0])),
                          minus(at_.place(t[2]), at_.place(t[0])));
  }

  bool is_joined_above(std::size_t ring, std::size_t other) const {
    return other > 0 && other < nodes_ && expected_.below[other] == ring;
  }

  /// A triangle with a side on one ring looks outward from it if its third corner is ahead. At
  /// a sharp bend a thick branch folds: the third corner falls behind, and then it must look
  /// inward.
  std::string facing() const {
    for (std::size_t n = 0; n < mesh_.triangle_count(); ++n) {
      Triangle t = mesh_.triangles[n];
      for (int turns = 0; turns < 2 && at_.ring_of(t[0]) != at_.ring_of(t[1]); ++turns)
        std::rotate(t.begin(), t.begin() + 1, t.end());
      const std::size_t ring = at_.ring_of(t[0]), third = at_.ring_of(t[2]);
      const double sign = is_joined_above(ring, third) ? 1.0 : -1.0;
      const Point side = minus(at_.place(t[2]), at_.place(t[0]));
      const double ahead = sign * scalar_product(side, expected_.rings[ring].looks);
      if (std::abs(ahead) <= tube_rounding * length(side)) continue;
      const double out = scalar_product(normal_of(t), plus(at_.outward(t[0]), at_.outward(t[1])));
      if (out * ahead < 0.0) return fmt::format("triangle {} of a branch looks inward", n);
    }
    return {};
  }

  /// Sums over the triangles at a corner, weighted by area, on both sides of the seam.
  std::string normals() const {
    std::vector<Point> sums(expected_.rings.size() * corners_, Point{0.0, 0.0, 0.0});
    std::vector<double> sizes(sums.size(), 0.0);
    for (const Triangle& triangle : mesh_.triangles)
      for (const int corner : sewn_up(triangle)) {
        const Point normal = normal_of(triangle);
        const auto c = static_cast<std::size_t>(corner);
        sums[c] = plus(sums[c], normal);
        sizes[c] += length(normal);
      }
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const std::size_t c = at_.ring_of(v) * corners_ + at_.corner_of(v) % corners_;
      const Point found = point_of(mesh_.normals[v]);
      const bool is_alone = sizes[c] == 0.0;  // no tube at all: straight from the center
      const Point expected = is_alone ? at_.outward(v) : sums[c];
      const double size = is_alone ? 1.0 : sizes[c];
      if (!(length(minus(times(length(expected), found), expected)) <= tube_rounding * size))
        return fmt::format(
            "vertex {}: normal ({:.6g}, {:.6g}, {:.6g}) is not that of its triangles", v, found.x,
            found.y, found.z);
    }
    return {};
  }

  const TriangleMesh& mesh_;
  const ExpectedRings& expected_;
  MeshRings at_;
  std::size_t corners_;
  std::size_t nodes_;
};

}  // namespace

std::string objection_to_tubes(const TriangleMesh& mesh, const ExpectedRings& expected,
                               int corners) {
  return TubeCheck(mesh, expected, corners).run();
}

}  // namespace phytobench
