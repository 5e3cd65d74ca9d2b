// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/node_driven/point_search.hpp"

namespace phytobench {

/// Search for reaches that cover much of the cloud, infinite ones included: a k-d tree over the
/// points in which every branch knows the largest squared distance that any of its live points
/// still has to its node. A new node skips what it cannot improve, however far it can reach.
class TreeSearch final : public PointSearch {
 public:
  static constexpr std::size_t default_leaf_size = 16;
  explicit TreeSearch(std::size_t leaf_size = default_leaf_size) : leaf_size_(leaf_size) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup);

  void associate(std::span<const SearchableNode> nodes, NodeIndex first,
                 std::span<NodeIndex> node_of_point, std::vector<PointIndex>& reached) override;
  void remove(std::span<const SearchableNode> killers, double squared_kill,
              std::vector<PointIndex>& removed) override;
  std::size_t bytes() const override;
  WorkCounters counters() const override { return work_; }

 private:
  struct Point {
    Vector3 position;
    double best;  ///< squared distance to its node so far
    PointIndex index;
  };
  /// A subtree of points_[begin, end). The left child follows its parent.
  struct Branch {
    Vector3 low, high;
    double worst;  ///< largest best of its live points; negative if there are none
    std::int32_t begin, end;
    std::int32_t right;  ///< 0 for a leaf
  };
  /// A subtree that one thread searches, and what it finds there.
  struct Part {
    std::int32_t branch;
    std::vector<PointIndex> reached;
    std::vector<PointIndex> removed;
    WorkCounters work;
  };
  struct Visit;

  std::int32_t build(std::int32_t begin, std::int32_t end);
  void choose_parts(std::int32_t branch, int depth);
  void update_above(std::int32_t branch, int depth);
  template <class Body>
  void for_each_part(const Body& body);
  void associate_in(std::int32_t branch, const Visit& visit, Part& part);
  void associate_leaf(Branch& leaf, const Visit& visit, Part& part);
  void remove_in(std::int32_t branch, const Vector3& killer, double squared_kill, Part& part);
  void remove_from_leaf(Branch& leaf, const Vector3& killer, double squared_kill, Part& part);

  std::size_t leaf_size_;
  EngineSetup setup_;
  int parts_depth_ = 0;
  std::vector<Point> points_;
  std::vector<Branch> branches_;
  std::vector<Part> parts_;
  WorkCounters work_;
};

}  // namespace phytobench
