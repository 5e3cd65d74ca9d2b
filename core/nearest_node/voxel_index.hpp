// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench {

/// Nodes in a grid with cells as wide as the influence distance: the nearest one lies in a point's
/// own cell or one of its 26 neighbours ([Brzoska2019] sec. 5.2.2, fig. 35). Points never move, so
/// the cell of each point and the neighbours of each cell are found once. Only cells that some
/// point can reach exist at all; nodes elsewhere are never anybody's nearest within reach.
class VoxelIndex {
 private:
  struct CellKey {
    std::int64_t x, y, z;
    friend bool operator==(const CellKey&, const CellKey&) = default;
  };

  struct CellKeyHash {
    std::size_t operator()(const CellKey& key) const {
      std::uint64_t hash = 0;
      for (const std::int64_t part : {key.x, key.y, key.z}) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  struct BinnedNode {
    SearchableNode node;
    NodeIndex index;
  };

 public:
  void reset(std::span<const Vector3> points, double influence_distance) {
    // Slightly wider than the influence distance, and at most 2^30 cells from the origin to any
    // point: a node exactly at the influence distance must not fall two cells away through
    // rounding.
    edge_ = std::max(influence_distance * (1.0 + 0x1p-20), largest_coordinate(points) * 0x1p-30);
    count_ = 0;
    cells_.clear();
    cell_of_key_.clear();
    neighbours_.clear();
    block_of_point_.assign(points.size(), 0);
    std::unordered_map<CellKey, std::uint32_t, CellKeyHash> block_of_key;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const CellKey key = key_of(points[i]);
      const auto [entry, is_new] =
          block_of_key.try_emplace(key, static_cast<std::uint32_t>(neighbours_.size()));
      if (is_new) neighbours_.push_back(block_around(key));
      block_of_point_[i] = entry->second;
    }
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    for (const SearchableNode& node : nodes) {
      const auto cell = cell_of_key_.find(key_of(node.position));
      if (cell != cell_of_key_.end()) cells_[cell->second].push_back({node, count_});
      ++count_;
    }
    return nodes.size();
  }

  NearestHit nearest(PointIndex point_index, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    for (const std::uint32_t cell :
         neighbours_[block_of_point_[static_cast<std::size_t>(point_index)]]) {
      for (const BinnedNode& binned : cells_[cell]) {
        const double squared = squared_distance(point, binned.node.position);
        if (!best.beaten_by(squared, binned.index)) continue;
        if constexpr (counts_inner_loop) ++work.angle_tests;
        if (!perception.within_angle(binned.node.position, binned.node.direction, point, squared))
          continue;
        best = {binned.index, squared};
      }
      work.search_evaluations += cells_[cell].size();
    }
    work.cells_visited += 27;
    return best;
  }

 private:
  using Block = std::array<std::uint32_t, 27>;  ///< a cell and its neighbours

  static double largest_coordinate(std::span<const Vector3> points) {
    double largest = 0.0;
    for (const Vector3& p : points)
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
  }

  /// Any monotone map with steps of at most one per edge keeps the search correct, so far-away
  /// coordinates may be clamped.
  std::int64_t cell_coordinate(double value) const {
    constexpr double limit = 0x1p60;
    return static_cast<std::int64_t>(std::clamp(std::floor(value / edge_), -limit, limit));
  }

  CellKey key_of(const Vector3& v) const {
    return {cell_coordinate(v.x), cell_coordinate(v.y), cell_coordinate(v.z)};
  }

  Block block_around(const CellKey& centre) {
    Block block{};
    std::size_t place = 0;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          block[place++] = cell_at({centre.x + dx, centre.y + dy, centre.z + dz});
    return block;
  }

  std::uint32_t cell_at(const CellKey& key) {
    const auto [entry, is_new] =
        cell_of_key_.try_emplace(key, static_cast<std::uint32_t>(cells_.size()));
    if (is_new) cells_.emplace_back();
    return entry->second;
  }

  double edge_ = 1.0;
  NodeIndex count_ = 0;
  std::vector<std::vector<BinnedNode>> cells_;
  std::unordered_map<CellKey, std::uint32_t, CellKeyHash> cell_of_key_;
  std::vector<Block> neighbours_;
  std::vector<std::uint32_t> block_of_point_;
};

}  // namespace phytobench
