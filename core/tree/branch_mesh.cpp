// SPDX-License-Identifier: MIT
#include "core/tree/branch_mesh.hpp"

#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

constexpr Vector3 up{0.0, 1.0, 0.0};

std::vector<Vector3> unit_circle(int circle_resolution) {
  PHYTOBENCH_EXPECT(circle_resolution >= 3);
  std::vector<Vector3> circle;
  for (int i = 0; i < circle_resolution; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / circle_resolution;
    circle.push_back({std::cos(angle), 0.0, std::sin(angle)});
  }
  return circle;
}

Vector3 normalised_or(const Vector3& v, const Vector3& otherwise) {
  const double length = norm(v);
  return length > 0.0 ? v / length : otherwise;
}

class BranchMesher {
 public:
  BranchMesher(const Skeleton& skeleton, std::span<const double> radii,
               const BranchMeshOptions& options)
      : skeleton_(skeleton),
        radii_(radii),
        options_(options),
        circle_(unit_circle(options.circle_resolution)),
        ring_size_(circle_.size() + 1) {}

  BranchMesh run() {
    make_room();
    turn_rings();
    measure_heights();
    for (std::size_t node = 0; node < skeleton_.node_count(); ++node)
      put_ring(node, skeleton_.positions()[node], radii_[node], turned_[node], heights_[node]);
    put_duplicates();
    for (const std::int32_t node : depth_first()) {
      const auto n = static_cast<std::size_t>(node);
      join(below_[n], n);
    }
    set_vertex_normals(result_.mesh, seams());
    return std::move(result_);
  }

 private:
  std::size_t parent_of(std::size_t node) const {
    return static_cast<std::size_t>(skeleton_.parents()[node]);
  }

  bool is_duplicated(std::size_t node) const {
    return needs_own_ring(radii_[node], radii_[parent_of(node)], options_.duplicate_ratio);
  }

  void make_room() {
    for (std::size_t node = 1; node < skeleton_.node_count(); ++node)
      result_.duplicated_rings += is_duplicated(node);
    rings_ = skeleton_.node_count() + result_.duplicated_rings;
    TriangleMesh& mesh = result_.mesh;
    mesh.positions.resize(rings_ * ring_size_);
    mesh.normals.resize(rings_ * ring_size_);
    mesh.texture_points.resize(rings_ * ring_size_);
    mesh.triangles.reserve(2 * circle_.size() * skeleton_.edge_count());
  }

  /// What turns the horizontal unit circle into each node's ring.
  void turn_rings() {
    normals_ = ring_normals(skeleton_, radii_, options_.single_child_normal);
    turned_.reserve(normals_.size());
    turned_.push_back(Rotation::between(up, normals_[0]));
    for (std::size_t node = 1; node < normals_.size(); ++node)
      turned_.push_back(turned_from(parent_of(node), normals_[node]));
  }

  Rotation turned_from(std::size_t below, const Vector3& normal) const {
    if (options_.ring_turn == RingTurn::from_vertical) return Rotation::between(up, normal);
    return Rotation::between(normals_[below], normal) * turned_[below];
  }

  Rotation turned_towards(std::size_t node, std::size_t below) const {
    const Vector3 edge = skeleton_.positions()[node] - skeleton_.positions()[below];
    return turned_from(below, normalised_or(edge, normals_[below]));
  }

  /// Distance from the root along the branches: where on the bark texture a ring lies.
  void measure_heights() {
    heights_.assign(skeleton_.node_count(), 0.0);
    for (std::size_t node = 1; node < heights_.size(); ++node) {
      const std::size_t below = parent_of(node);
      heights_[node] =
          heights_[below] + norm(skeleton_.positions()[node] - skeleton_.positions()[below]);
    }
  }

  void put_ring(std::size_t ring, const Vector3& center, double radius, const Rotation& turned,
                double height) {
    const Vector3 across = turned({1.0, 0.0, 0.0}), along = turned({0.0, 0.0, 1.0});
    const std::size_t first = ring * ring_size_;
    TriangleMesh& mesh = result_.mesh;
    for (std::size_t i = 0; i < ring_size_; ++i) {
      const Vector3& corner = circle_[i == circle_.size() ? 0 : i];
      const Vector3 outward = corner.x * across + corner.z * along;
      mesh.positions[first + i] = center + radius * outward;
      mesh.normals[first + i] = outward;
      mesh.texture_points[first + i] = {
          static_cast<double>(i) / static_cast<double>(circle_.size()),
          height / options_.texture_length};
    }
  }

  /// Notes for every node which ring it is joined to.
  void put_duplicates() {
    below_.resize(skeleton_.node_count());
    std::size_t next = skeleton_.node_count();
    for (std::size_t node = 1; node < skeleton_.node_count(); ++node) {
      const std::size_t parent = parent_of(node);
      below_[node] = parent;
      if (!is_duplicated(node)) continue;
      below_[node] = next++;
      put_ring(below_[node], skeleton_.positions()[parent], radii_[node],
               turned_towards(node, parent), heights_[parent]);
    }
  }

  /// All nodes but the root, each branch to its end before the next: what is cut off a mesh in this
  /// order has few vertices in common with the rest.
  std::vector<std::int32_t> depth_first() const {
    const ChildLists children(skeleton_);
    std::vector<std::int32_t> order, waiting{0};
    order.reserve(skeleton_.node_count());
    while (!waiting.empty()) {
      const std::int32_t node = waiting.back();
      waiting.pop_back();
      if (node != 0) order.push_back(node);
      const auto above = children.of(node);
      waiting.insert(waiting.end(), above.rbegin(), above.rend());
    }
    return order;
  }

  void join(std::size_t below, std::size_t above) {
    const auto low = static_cast<std::uint32_t>(below * ring_size_);
    const auto high = static_cast<std::uint32_t>(above * ring_size_);
    for (std::uint32_t i = 0; i < circle_.size(); ++i) {
      result_.mesh.triangles.push_back({low + i, high + i, low + i + 1});
      result_.mesh.triangles.push_back({low + i + 1, high + i, high + i + 1});
    }
  }

  std::vector<std::array<std::uint32_t, 2>> seams() const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::size_t ring = 0; ring < rings_; ++ring) {
      const auto first = static_cast<std::uint32_t>(ring * ring_size_);
      pairs.push_back({first, first + static_cast<std::uint32_t>(circle_.size())});
    }
    return pairs;
  }

  const Skeleton& skeleton_;
  std::span<const double> radii_;
  const BranchMeshOptions& options_;
  std::vector<Vector3> circle_;
  std::size_t ring_size_;
  std::size_t rings_ = 0;
  std::vector<Vector3> normals_;
  std::vector<Rotation> turned_;
  std::vector<double> heights_;
  std::vector<std::size_t> below_;
  BranchMesh result_;
};

}  // namespace

std::vector<Vector3> ring(const Vector3& center, double radius, const Rotation& turned,
                          int circle_resolution) {
  std::vector<Vector3> points = unit_circle(circle_resolution);
  for (Vector3& point : points) point = center + radius * turned(point);
  return points;
}

std::vector<Vector3> ring_normals(const Skeleton& skeleton, std::span<const double> radii,
                                  SingleChildNormal single_child) {
  const std::size_t nodes = skeleton.node_count();
  std::vector<Vector3> sums(nodes);  // of the edges to the children, weighted
  std::vector<std::int32_t> children(nodes, 0);
  for (std::size_t node = 1; node < nodes; ++node) {
    const auto below = static_cast<std::size_t>(skeleton.parents()[node]);
    const Vector3 edge = skeleton.positions()[node] - skeleton.positions()[below];
    sums[below] = sums[below] + radii[node] * edge;
    ++children[below];
  }
  std::vector<Vector3> normals(nodes);
  normals[0] = normalised_or(sums[0], up);
  for (std::size_t node = 1; node < nodes; ++node) {
    const auto below = static_cast<std::size_t>(skeleton.parents()[node]);
    const Vector3 incoming =
        normalised_or(skeleton.positions()[node] - skeleton.positions()[below], normals[below]);
    const Vector3 outgoing = normalised_or(sums[node], incoming);
    const bool bisects = children[node] == 1 && single_child == SingleChildNormal::bisector;
    normals[node] = bisects ? normalised_or(incoming + outgoing, incoming) : outgoing;
  }
  return normals;
}

bool needs_own_ring(double child_radius, double parent_radius, double duplicate_ratio) {
  return child_radius <= duplicate_ratio * parent_radius;
}

BranchMesh mesh_branches(const Skeleton& skeleton, std::span<const double> radii,
                         const BranchMeshOptions& options) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  return BranchMesher(skeleton, radii, options).run();
}

}  // namespace phytobench
