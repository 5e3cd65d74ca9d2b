// SPDX-License-Identifier: MIT
// An engine to be broken on purpose: it keeps nodes in blocks of 40 with a box around each, and
// passes over blocks that are too far away. A policy replaces one part of it; what the policy
// leaves alone is as it should be.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench {

/// Nothing is broken.
struct Unbroken {
  /// How often a node of the block is looked at.
  static std::size_t looks(std::size_t) { return 1; }

  /// Whether a block can hold a nearer node, or an equally near one.
  static bool is_worth_opening(double squared_distance_to_box, const NearestHit& best) {
    return squared_distance_to_box <= best.squared_distance;
  }

  static const std::vector<SearchableNode>& nodes_of(const std::vector<SearchableNode>& block) {
    return block;
  }

  static bool wins(double squared, NodeIndex candidate, const NearestHit& best) {
    return best.beaten_by(squared, candidate);
  }
};

template <class Policy>
class BlockedScan {
 public:
  void reset(std::span<const Vector3>, double) { blocks_.clear(); }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    for (const SearchableNode& node : nodes) {
      if (blocks_.empty() || blocks_.back().nodes.size() == nodes_of_block)
        blocks_.emplace_back().nodes.reserve(nodes_of_block);
      blocks_.back().nodes.push_back(node);
      blocks_.back().box.extend(node.position);
    }
    return nodes.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      ++work.cells_visited;
      if (!Policy::is_worth_opening(squared_distance_to(blocks_[b].box, point), best)) continue;
      const auto& nodes = Policy::nodes_of(blocks_[b].nodes);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t looks = Policy::looks(i); looks > 0; --looks)
          look_at(nodes[i], static_cast<NodeIndex>(b * nodes_of_block + i), point, perception, best,
                  work);
    }
    return best;
  }

 private:
  static constexpr std::size_t nodes_of_block = 40;

  struct Block {
    std::vector<SearchableNode> nodes;
    BoundingBox box;
  };

  /// Rounded as squared_distance() is, so that it never exceeds that of a node in the box.
  static double squared_distance_to(const BoundingBox& box, const Vector3& point) {
    return squared_distance(point, {std::clamp(point.x, box.low().x, box.high().x),
                                    std::clamp(point.y, box.low().y, box.high().y),
                                    std::clamp(point.z, box.low().z, box.high().z)});
  }

  static void look_at(const SearchableNode& node, NodeIndex index, const Vector3& point,
                      const Perception& perception, NearestHit& best, WorkCounters& work) {
    ++work.search_evaluations;
    const double squared = squared_distance(point, node.position);
    if (squared > perception.squared_reach() || !Policy::wins(squared, index, best)) return;
    if constexpr (counts_inner_loop) ++work.angle_tests;
    if (!perception.within_angle(node.position, node.direction, point, squared)) return;
    best = {index, squared};
  }

  std::vector<Block> blocks_;
};

}  // namespace phytobench
