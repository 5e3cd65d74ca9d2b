// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/pair_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {

namespace {

/// Looks at all pairs and counts those that count.
class PairCounter final : public NearestNodeEngine {
 public:
  explicit PairCounter(PairFloor& floor)
      : inner_(engine_named("node_driven").create()), floor_(floor) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    points_ = points;
    setup_ = setup;
    sort_into_cells();
    inner_->reset(points, setup);
  }

  Assignment associate(std::span<const SearchableNode> nodes) override {
    const double reach = setup_.influence_distance;
    for (const SearchableNode& node : nodes)
      floor_.association += count_around(node.position, reach * reach);
    return inner_->associate(nodes);
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const auto removed = inner_->kill(killers, distance);
    floor_.removal += removed.size();
    for (const PointIndex point : removed)
      entries_[place_of_point_[static_cast<std::size_t>(point)]].is_live = false;
    return removed;
  }

  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  struct Entry {
    std::int64_t layer;  ///< cell along z
    Vector3 position;
    bool is_live = true;
  };

  /// All cells with the same x and y.
  struct Column {
    std::int64_t x, y;
    std::size_t begin = 0;  ///< its first entry
    friend bool operator<(const Column& a, const Column& b) {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    }
  };

  Cell cell_of(const Vector3& v) const {
    const auto along = [this](double value) {
      return static_cast<std::int64_t>(std::clamp(std::floor(value / edge_), -0x1p60, 0x1p60));
    };
    return {along(v.x - corner_.x), along(v.y - corner_.y), along(v.z - corner_.z)};
  }

  void sort_into_cells() {
    BoundingBox box;
    for (const Vector3& point : points_) box.extend(point);
    const Vector3 extent = box.extent();
    corner_ = box.low();  // far from the origin the cells would round away
    edge_ = std::min(setup_.influence_distance,
                     2.0 * std::max({extent.x, extent.y, extent.z, 1e-300})) *
            (1.0 + 0x1p-20);
    std::vector<std::pair<Cell, PointIndex>> sorted;
    sorted.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      sorted.emplace_back(cell_of(points_[i]), static_cast<PointIndex>(i));
    std::sort(sorted.begin(), sorted.end());
    entries_.clear();
    columns_.clear();
    place_of_point_.resize(points_.size());
    for (const auto& [cell, point] : sorted) {
      if (columns_.empty() || columns_.back().x != cell[0] || columns_.back().y != cell[1])
        columns_.push_back({.x = cell[0], .y = cell[1], .begin = entries_.size()});
      place_of_point_[static_cast<std::size_t>(point)] = entries_.size();
      entries_.push_back({.layer = cell[2], .position = points_[static_cast<std::size_t>(point)]});
    }
  }

  std::uint64_t count_around(const Vector3& node, double squared_reach) const {
    std::uint64_t count = 0;
    const Cell own = cell_of(node);
    for (std::int64_t x = own[0] - 1; x <= own[0] + 1; ++x) {
      const Column first{.x = x, .y = own[1] - 1};
      for (auto column = std::lower_bound(columns_.begin(), columns_.end(), first);
           column != columns_.end() && column->x == x && column->y <= own[1] + 1; ++column)
        count += count_in(*column, own[2], node, squared_reach);
    }
    return count;
  }

  std::uint64_t count_in(const Column& column, std::int64_t layer, const Vector3& node,
                         double squared_reach) const {
    const std::size_t next = static_cast<std::size_t>(&column - columns_.data()) + 1;
    const auto end =
        entries_.begin() + static_cast<std::ptrdiff_t>(next < columns_.size() ? columns_[next].begin
                                                                              : entries_.size());
    auto entry = std::lower_bound(
        entries_.begin() + static_cast<std::ptrdiff_t>(column.begin), end, layer - 1,
        [](const Entry& one, std::int64_t lowest) { return one.layer < lowest; });
    std::uint64_t count = 0;
    for (; entry != end && entry->layer <= layer + 1; ++entry)
      count += entry->is_live && squared_distance(entry->position, node) <= squared_reach;
    return count;
  }

  std::unique_ptr<NearestNodeEngine> inner_;
  PairFloor& floor_;
  std::span<const Vector3> points_;
  EngineSetup setup_;
  double edge_ = 1.0;
  Vector3 corner_;
  std::vector<Entry> entries_;   // by column, then by layer
  std::vector<Column> columns_;  // sorted
  std::vector<std::size_t> place_of_point_;
};

}  // namespace

PairFloor count_pairs(const Seedling& seedling, const GrowthRun& run) {
  PairFloor floor;
  PairCounter counter(floor);
  grow_crown(seedling, counter, run);
  return floor;
}

}  // namespace phytobench
