// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/leaf_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr double leaf_rounding = 1e-9;
constexpr double deviations = 5.0;  // exceeded once in two million

/// Whether the mean of `count` numbers of this standard deviation is likely.
bool is_likely(double mean, double expected, double deviation, double count) {
  return std::abs(mean - expected) <= deviations * deviation / std::sqrt(count) + leaf_rounding;
}

std::string objection_to_number(std::size_t leaves, double bearing, double per_node) {
  const double chance = per_node - std::floor(per_node);
  const double deviation = std::sqrt(bearing * chance * (1.0 - chance));
  const auto found = static_cast<double>(leaves);
  if (std::abs(found - bearing * per_node) <= deviations * deviation) return {};
  return fmt::format("{} leaves on {} nodes that may carry them", leaves, bearing);
}

/// Where between the ends of an edge a place lies, 0 to 1; NaN if elsewhere.
double place_on_edge(const Vector3& place, const Vector3& from, const Vector3& to) {
  const Vector3 edge = to - from;
  const double share = dot(place - from, edge) / squared_norm(edge);
  const bool is_on_it = norm(from + share * edge - place) <= leaf_rounding * norm(edge) &&
                        share >= -leaf_rounding && share <= 1.0 + leaf_rounding;
  return is_on_it ? share : std::nan("");
}

/// Vertices 4 k to 4 k + 3 of a leaf mesh and triangles 2 k and 2 k + 1.
class LeafSide {
 public:
  LeafSide(const TriangleMesh& mesh, std::size_t k) : mesh_(mesh), k_(k) {}

  const Vector3& corner(std::size_t i) const { return mesh_.positions[4 * k_ + i % 4]; }
  const Vector3& normal() const { return mesh_.normals[4 * k_]; }

  std::string objection(const Leaf& leaf) const {
    if (!is_square(leaf)) return "is no square of the leaf's size around its place";
    if (!has_one_normal(leaf.size)) return "has another normal than its square";
    if (!is_covered_once()) return "is not covered by two triangles that face as it does";
    if (!has_whole_texture()) return "does not show the whole texture";
    return {};
  }

 private:
  bool is_square(const Leaf& leaf) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const double away = norm(corner(i) - leaf.position);
      const double side = norm(corner(i + 1) - corner(i));
      if (!(std::abs(away - std::sqrt(0.5) * leaf.size) <= leaf_rounding * leaf.size)) return false;
      if (!(std::abs(side - leaf.size) <= leaf_rounding * leaf.size)) return false;
    }
    const Vector3 middle = 0.5 * (corner(0) + corner(2));
    return norm(middle - leaf.position) <= leaf_rounding * leaf.size;
  }

  bool has_one_normal(double size) const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (mesh_.normals[4 * k_ + i] != normal()) return false;
      if (!(std::abs(dot(normal(), corner(i + 1) - corner(i))) <= leaf_rounding * size))
        return false;
    }
    return std::abs(norm(normal()) - 1.0) <= leaf_rounding;
  }

  /// Two triangles of three of the four corners each, so each half of the square; they are not the
  /// same half if they lack opposite corners.
  bool is_covered_once() const {
    std::array<std::size_t, 2> lacking{};
    for (std::size_t half = 0; half < 2; ++half) {
      const Triangle& triangle = mesh_.triangles[2 * k_ + half];
      std::size_t sum = 0;
      for (const std::uint32_t vertex : triangle) {
        if (vertex / 4 != k_) return false;
        sum += vertex % 4;
      }
      if (sum > 6) return false;
      lacking[half] = 6 - sum;
      const Vector3 &a = mesh_.positions[triangle[0]], &b = mesh_.positions[triangle[1]],
                    &c = mesh_.positions[triangle[2]];
      if (!(dot(cross(b - a, c - a), normal()) > 0.0)) return false;
    }
    return lacking[0] % 2 == lacking[1] % 2 && lacking[0] != lacking[1];
  }

  /// Its corners are those of the texture, one after the other.
  bool has_whole_texture() const {
    std::array<bool, 4> is_shown{};
    for (std::size_t i = 0; i < 4; ++i) {
      const TexturePoint &here = mesh_.texture_points[4 * k_ + i],
                         &next = mesh_.texture_points[4 * k_ + (i + 1) % 4];
      if ((here.u != 0.0 && here.u != 1.0) || (here.v != 0.0 && here.v != 1.0)) return false;
      if ((here.u == next.u) == (here.v == next.v)) return false;
      is_shown[(here.u == 1.0 ? 1u : 0u) + (here.v == 1.0 ? 2u : 0u)] = true;
    }
    return std::all_of(is_shown.begin(), is_shown.end(), [](bool shown) { return shown; });
  }

  const TriangleMesh& mesh_;
  std::size_t k_;
};

/// Of both sides of one square, which stands across `axis`.
std::string objection_to_square(const TriangleMesh& mesh, std::size_t square, const Leaf& leaf,
                                const Vector3& axis) {
  const LeafSide front(mesh, 2 * square), back(mesh, 2 * square + 1);
  for (const LeafSide& side : {front, back})
    if (std::string wrong = side.objection(leaf); !wrong.empty()) return wrong;
  if (!(std::abs(std::abs(dot(front.normal(), axis)) - 1.0) <= leaf_rounding))
    return "is not turned as the leaf is";
  if (!(norm(front.normal() + back.normal()) <= leaf_rounding)) return "has both sides on one side";
  for (std::size_t i = 0; i < 4; ++i)
    if (front.corner(i) != back.corner(i)) return "has sides at two places";
  return {};
}

}  // namespace

std::string objection_to_leaves(std::span<const Leaf> leaves, const Skeleton& skeleton,
                                std::span<const double> radii, const LeafOptions& options) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  const auto fewest = static_cast<std::size_t>(std::floor(options.per_node));
  const auto most = static_cast<std::size_t>(std::ceil(options.per_node));
  std::size_t next = 0;
  double bearing = 0.0, places = 0.0, sizes = 0.0;
  for (const double radius : radii.subspan(1)) bearing += radius < options.radius_limit;
  if (std::string wrong = objection_to_number(leaves.size(), bearing, options.per_node);
      !wrong.empty())
    return wrong;
  for (std::size_t node = 1; node < radii.size(); ++node) {
    if (radii[node] >= options.radius_limit) continue;
    std::size_t here = 0;
    for (; here < most && next < leaves.size(); ++here, ++next) {
      const double place =
          place_on_edge(leaves[next].position, skeleton.position(skeleton.parents()[node]),
                        skeleton.positions()[node]);
      if (std::isnan(place)) break;
      places += place;
      sizes += leaves[next].size;
    }
    if (here < fewest)
      return fmt::format("leaf {} is not on the edge below node {}, which lacks leaves", next,
                         node);
  }
  if (next < leaves.size())
    return fmt::format("leaf {} is on no edge that may carry one more", next);
  for (std::size_t k = 0; k < leaves.size(); ++k)
    if (!(leaves[k].size > 0.0)) return fmt::format("leaf {} has size {}", k, leaves[k].size);
  const auto count = static_cast<double>(leaves.size());
  constexpr double of_uniform = 0.28867513459481287;  // 1 / sqrt(12)
  if (count > 0.0 && !is_likely(places / count, 0.5, of_uniform, count))
    return fmt::format("leaves are not spread over their edges: {:.3g} in the mean",
                       places / count);
  // Sizes that are not positive are drawn again, which shifts the mean where spreads are wide.
  constexpr double widest_spread = 0.25;
  if (count > 0.0 && options.size_spread <= widest_spread &&
      !is_likely(sizes / count / options.size, 1.0, options.size_spread, count))
    return fmt::format("leaves of mean size {:.6g} instead of {:.6g}", sizes / count, options.size);
  return {};
}

std::string objection_to_leaf_mesh(const TriangleMesh& mesh, std::span<const Leaf> leaves,
                                   LeafShape shape) {
  const std::size_t squares = shape == LeafShape::cross_foil ? 2 : 1;
  const std::size_t sides = 2 * squares * leaves.size();
  struct Count {
    const char* what;
    std::size_t found, expected;
  };
  for (const auto& [what, found, expected] :
       {Count{"vertices of leaves", mesh.vertex_count(), 4 * sides},
        Count{"normals of leaves", mesh.normals.size(), 4 * sides},
        Count{"texture points of leaves", mesh.texture_points.size(), 4 * sides},
        Count{"triangles of leaves", mesh.triangle_count(), 2 * sides}})
    if (found != expected) return fmt::format("{} {} instead of {}", found, what, expected);
  for (std::size_t k = 0; k < leaves.size(); ++k)
    for (std::size_t square = 0; square < squares; ++square) {
      const Vector3 axis = leaves[k].turned(square == 0 ? Vector3{0, 0, 1} : Vector3{1, 0, 0});
      const std::string wrong = objection_to_square(mesh, k * squares + square, leaves[k], axis);
      if (!wrong.empty()) return fmt::format("square {} of leaf {} {}", square, k, wrong);
    }
  return {};
}

}  // namespace phytobench
