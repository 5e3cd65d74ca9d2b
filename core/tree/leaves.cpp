// SPDX-License-Identifier: MIT
#include "core/tree/leaves.hpp"

#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

// Streams of one seed: how many leaves a node shows, and what each looks like.
enum LeafStream : std::uint64_t { count_stream = 101, look_stream = 102 };

/// Random numbers set aside for one node's leaves and for one leaf.
constexpr std::uint64_t leaves_per_node = 1024;
constexpr std::uint64_t numbers_per_leaf = 64;

bool bears_leaves(double radius, double radius_limit) {
  return radius < radius_limit;
}

std::size_t leaves_shown(std::size_t node, const LeafOptions& options) {
  const double whole = std::floor(options.per_node);
  const bool one_more = random_unit(options.seed, count_stream, node) < options.per_node - whole;
  return static_cast<std::size_t>(whole) + one_more;
}

/// The numbers of one leaf, in order.
class LeafNumbers {
 public:
  LeafNumbers(std::uint64_t seed, std::size_t node, std::size_t leaf)
      : seed_(seed), next_((node * leaves_per_node + leaf) * numbers_per_leaf) {}
  double next_unit() { return random_unit(seed_, look_stream, next_++); }

  /// Standard normal (Box and Muller).
  double next_normal() {
    const double radius = std::sqrt(-2.0 * std::log1p(-next_unit()));
    return radius * std::cos(2.0 * std::numbers::pi * next_unit());
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_;
};

Leaf make_leaf(const Vector3& from, const Vector3& to, LeafNumbers numbers,
               const LeafOptions& options) {
  Leaf leaf;
  leaf.position = from + numbers.next_unit() * (to - from);
  const double u1 = numbers.next_unit(), u2 = numbers.next_unit();
  leaf.turned = Rotation::uniform(u1, u2, numbers.next_unit());
  constexpr int tries = 28;  // what is set aside; one in 3.5 million needs a second at spread 0.2
  for (int i = 0; i < tries && !(leaf.size > 0.0); ++i)
    leaf.size = options.size * (1.0 + options.size_spread * numbers.next_normal());
  if (!(leaf.size > 0.0)) leaf.size = options.size;
  return leaf;
}

/// Two sides of a square that spans `across` and `along` from its center.
void append_square(TriangleMesh& mesh, const Vector3& center, const Vector3& across,
                   const Vector3& along) {
  const Vector3 normal = cross(across, along) / norm(cross(across, along));
  constexpr double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const double side : {1.0, -1.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (const auto& corner : corners) {
      mesh.positions.push_back(center + corner[0] * across + corner[1] * along);
      mesh.normals.push_back(side * normal);
      mesh.texture_points.push_back({0.5 + 0.5 * corner[0], 0.5 + 0.5 * corner[1]});
    }
    if (side > 0.0) {
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    } else {
      mesh.triangles.push_back({first, first + 2, first + 1});
      mesh.triangles.push_back({first, first + 3, first + 2});
    }
  }
}

}  // namespace

std::size_t leaf_bearing_nodes(const Skeleton& skeleton, std::span<const double> radii,
                               double radius_limit) {
  std::size_t count = 0;
  for (std::size_t node = 1; node < skeleton.node_count(); ++node)
    count += bears_leaves(radii[node], radius_limit);
  return count;
}

std::vector<Leaf> make_leaves(const Skeleton& skeleton, std::span<const double> radii,
                              const LeafOptions& options) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  PHYTOBENCH_EXPECT(options.per_node >= 0.0 && options.per_node < leaves_per_node);
  std::vector<Leaf> leaves;
  for (std::size_t node = 1; node < skeleton.node_count(); ++node) {
    if (!bears_leaves(radii[node], options.radius_limit)) continue;
    const Vector3& parent = skeleton.position(skeleton.parents()[node]);
    const std::size_t shown = leaves_shown(node, options);
    for (std::size_t i = 0; i < shown; ++i)
      leaves.push_back(make_leaf(parent, skeleton.positions()[node],
                                 LeafNumbers(options.seed, node, i), options));
  }
  return leaves;
}

TriangleMesh mesh_leaves(std::span<const Leaf> leaves, LeafShape shape) {
  const std::size_t squares = leaves.size() * (shape == LeafShape::cross_foil ? 2 : 1);
  TriangleMesh mesh;
  mesh.positions.reserve(8 * squares);
  mesh.normals.reserve(8 * squares);
  mesh.texture_points.reserve(8 * squares);
  mesh.triangles.reserve(4 * squares);
  for (const Leaf& leaf : leaves) {
    const double half = 0.5 * leaf.size;
    const Vector3 x = half * leaf.turned({1, 0, 0}), y = half * leaf.turned({0, 1, 0});
    append_square(mesh, leaf.position, x, y);
    if (shape == LeafShape::cross_foil)
      append_square(mesh, leaf.position, half * leaf.turned({0, 0, 1}), y);
  }
  return mesh;
}

}  // namespace phytobench
