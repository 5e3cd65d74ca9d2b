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
    is_live_.assign(points.size(), 1);
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
    for (const PointIndex point : removed) is_live_[static_cast<std::size_t>(point)] = 0;
    return removed;
  }

  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }

 private:
  using Cell = std::array<std::int64_t, 3>;

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
    cells_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i)
      cells_.emplace_back(cell_of(points_[i]), static_cast<PointIndex>(i));
    std::sort(cells_.begin(), cells_.end());
  }

  std::uint64_t count_around(const Vector3& node, double squared_reach) const {
    std::uint64_t count = 0;
    const Cell own = cell_of(node);
    for (std::int64_t x = own[0] - 1; x <= own[0] + 1; ++x)
      for (std::int64_t y = own[1] - 1; y <= own[1] + 1; ++y) {
        const std::pair<Cell, PointIndex> from{{x, y, own[2] - 1}, -1};
        for (auto cell = std::lower_bound(cells_.begin(), cells_.end(), from);
             cell != cells_.end() && cell->first[0] == x && cell->first[1] == y &&
             cell->first[2] <= own[2] + 1;
             ++cell) {
          const auto i = static_cast<std::size_t>(cell->second);
          count += is_live_[i] && squared_distance(points_[i], node) <= squared_reach;
        }
      }
    return count;
  }

  std::unique_ptr<NearestNodeEngine> inner_;
  PairFloor& floor_;
  std::span<const Vector3> points_;
  EngineSetup setup_;
  double edge_ = 1.0;
  Vector3 corner_;
  std::vector<std::pair<Cell, PointIndex>> cells_;
  std::vector<std::uint8_t> is_live_;
};

}  // namespace

PairFloor count_pairs(const Seedling& seedling, const GrowthRun& run) {
  PairFloor floor;
  PairCounter counter(floor);
  grow_crown(seedling, counter, run);
  return floor;
}

}  // namespace phytobench
