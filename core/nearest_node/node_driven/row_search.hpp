// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/nearest_node/node_driven/point_search.hpp"
#include "core/nearest_node/node_driven/row_scan.hpp"

namespace phytobench {

/// Search for reaches of few to some thousand points: rows of cells, scanned in layers that are
/// shared out among threads.
///
/// A growing tree first removes the points around its new nodes and then associates the others with
/// the same nodes, so one scan serves both: remove() notes what associate() will be asked, unless
/// no association is to follow.
class RowSearch final : public PointSearch {
 public:
  /// False if the points do not suit this index; call nothing else then.
  bool reset(std::span<const Vector3> points, const EngineSetup& setup);

  void associate(std::span<const SearchableNode> nodes, NodeIndex first,
                 std::span<NodeIndex> node_of_point, std::vector<PointIndex>& reached) override;
  void remove(std::span<const SearchableNode> killers, double squared_kill,
              std::vector<PointIndex>& removed) override;
  std::size_t bytes() const override;
  WorkCounters counters() const override { return work_; }

 private:
  /// Rows that one thread scans, and what it finds there.
  struct Layer {
    std::int32_t first_z, end_z;
    double low, high;  ///< z of the nodes that may reach it
    std::vector<std::int32_t> chosen;
    std::vector<std::uint16_t> bricks;  ///< where the chosen are
    std::vector<std::int32_t> sorted;   ///< scratch of the sort
    std::vector<PointIndex> reached;
    ScanResult result;
  };

  void cut_into_layers();
  void look_as_far_as(double distance);
  void scan(std::span<const SearchableNode> nodes, double squared_kill);
  bool was_scanned(std::span<const SearchableNode> nodes) const;
  void choose_nodes(Layer& layer, std::span<const SearchableNode> nodes) const;
  void sort_by_brick(Layer& layer, std::span<const SearchableNode> nodes) const;
  void apply(Layer& layer, std::size_t from, NodeIndex first, std::span<NodeIndex> node_of_point);
  void compact_if_worthwhile();
  template <class Body>
  void for_each_layer(const Body& body);

  EngineSetup setup_;
  RowIndex index_;
  RowStencil stencil_;
  BoundingBox within_reach_;
  double bricks_per_length_ = 0.0;
  std::vector<Layer> layers_;
  std::vector<SearchableNode> scanned_;  ///< nodes whose hits are known and not yet used
  std::size_t slots_ = 0;                ///< in the runs of all cells
  std::size_t empty_slots_ = 0;          ///< of them
  int associations_ = 0;                 ///< so far
  bool sees_kills_only_ = false;         ///< the stencil does not cover the influence distance
  WorkCounters work_;
};

}  // namespace phytobench
