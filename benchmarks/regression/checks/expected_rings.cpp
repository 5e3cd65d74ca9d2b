// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/expected_rings.hpp"

namespace phytobench {

namespace {

namespace paper = oracles::brzoska2019;
using paper::Point;

/// Unit vectors that rings look along.
class Looks {
 public:
  Looks(const Skeleton& skeleton, std::span<const double> radii, SingleChildNormal single_child)
      : skeleton_(skeleton),
        single_child_(single_child),
        children_(radii.size(), 0),
        weighted_(radii.size(), Point{0.0, 0.0, 0.0}) {
    for (std::size_t i = 1; i < radii.size(); ++i) {
      const auto parent = static_cast<std::size_t>(skeleton.parents()[i]);
      ++children_[parent];
      weighted_[parent] = plus(weighted_[parent], times(radii[i], edge(i)));
    }
  }

  /// From the parent to the node.
  Point along(std::size_t node) const { return unit(edge(node)); }

  /// Of a node's ring: along the branch at a tip, halfway at a bend, and at a fork along the sum of
  /// the edges above, weighted by their radii.
  Point of(std::size_t node) const {
    if (children_[node] == 0) return node == 0 ? Point{0.0, 1.0, 0.0} : along(node);
    const Point above = unit(weighted_[node]);
    const bool is_bend = node != 0 && children_[node] == 1;
    if (!is_bend || single_child_ == SingleChildNormal::child) return above;
    return unit(plus(along(node), above));
  }

 private:
  static Point unit(const Point& v) { return over(v, length(v)); }

  Point edge(std::size_t node) const {
    return minus(point_of(skeleton_.positions()[node]),
                 point_of(skeleton_.position(skeleton_.parents()[node])));
  }

  const Skeleton& skeleton_;
  SingleChildNormal single_child_;
  std::vector<int> children_;
  std::vector<Point> weighted_;
};

}  // namespace

Point point_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

std::size_t ExpectedRings::open_rings() const {
  std::vector<std::size_t> tubes_above(rings.size(), 0);
  for (std::size_t node = 1; node < below.size(); ++node) ++tubes_above[below[node]];
  std::size_t open = duplicated + (tubes_above[0] == 1);
  for (std::size_t node = 1; node < below.size(); ++node) open += tubes_above[node] == 0;
  return open;
}

Point MeshRings::place(std::size_t vertex) const {
  return point_of(mesh_.positions[vertex]);
}

Point MeshRings::outward(std::size_t vertex) const {
  const ExpectedRing& ring = expected_.rings[ring_of(vertex)];
  return over(minus(place(vertex), ring.center), ring.radius);
}

ExpectedRings expected_rings(const Skeleton& skeleton, std::span<const double> radii,
                             const BranchMeshOptions& options) {
  const Looks looks(skeleton, radii, options.single_child_normal);
  ExpectedRings expected;
  expected.below.assign(radii.size(), 0);
  for (std::size_t node = 0; node < radii.size(); ++node) {
    ExpectedRing ring{point_of(skeleton.positions()[node]), radii[node], looks.of(node), node, 0.0};
    if (node > 0) {
      ring.turned_from = static_cast<std::size_t>(skeleton.parents()[node]);
      const ExpectedRing& parent = expected.rings[ring.turned_from];
      ring.height = parent.height + paper::equation_23(parent.center, ring.center);
      expected.below[node] = ring.turned_from;
    }
    expected.rings.push_back(ring);
  }
  for (std::size_t node = 1; node < radii.size(); ++node) {
    const std::size_t parent = expected.below[node];
    if (radii[node] > options.duplicate_ratio * radii[parent]) continue;
    ExpectedRing ring = expected.rings[parent];
    ring.radius = radii[node];
    ring.looks = looks.along(node);
    ring.turned_from = parent;
    expected.below[node] = expected.rings.size();
    expected.rings.push_back(ring);
    ++expected.duplicated;
  }
  return expected;
}

}  // namespace phytobench
