// SPDX-License-Identifier: MIT
// The voxel grid as the thesis explains it: where candidates come from, and what it saves to
// remember the voxel of each point and the neighbours of each voxel.
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

using Voxel = std::array<std::int64_t, 3>;

struct NumberedNode {
  SearchableNode node;
  NodeIndex index;
};

enum class Memory { none, voxels };

/// A plain voxel grid that counts how often it computes the index of a voxel.
class CountingVoxels final : public NearestNodeEngine {
 public:
  explicit CountingVoxels(Memory memory) : memory_(memory) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    points_ = points;
    edge_ = setup.influence_distance * (1.0 + 0x1p-20);
    perception_ = Perception(setup.influence_distance, setup.perception_half_angle_rad);
    nodes_.clear();
    blocks_.clear();
    block_of_point_.assign(points.size(), nullptr);
    dead_.assign(points.size(), false);
    node_.assign(points.size(), no_node);
    associated_.reset(points.size());
    count_ = 0;
    live_ = points.size();
    index_computations_ = 0;
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    for (const SearchableNode& node : new_nodes)
      nodes_[voxel_of(node.position)].push_back({node, count_++});
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (dead_[i]) continue;
      node_[i] = nearest(i);
      if (node_[i] != no_node) associated_.insert(static_cast<PointIndex>(i));
    }
    return {node_, associated_};
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override {
    removed_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (const SearchableNode& killer : killers)
        if (!dead_[i] &&
            squared_distance(points_[i], killer.position) <= kill_distance * kill_distance)
          remove(i);
    return removed_;
  }

  std::size_t live_points() const override { return live_; }
  WorkCounters counters() const override { return {}; }
  std::int64_t index_computations() const { return index_computations_; }

 private:
  using Block = std::array<std::vector<NumberedNode>*, 27>;

  Voxel voxel_of(const Vector3& v) {
    ++index_computations_;
    return {std::llround(std::floor(v.x / edge_)), std::llround(std::floor(v.y / edge_)),
            std::llround(std::floor(v.z / edge_))};
  }

  Block block_around(const Voxel& centre) {
    Block block;
    auto place = block.begin();
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z, ++index_computations_)
          *place++ = &nodes_[{centre[0] + x, centre[1] + y, centre[2] + z}];
    return block;
  }

  const Block& block_of(std::size_t point) {
    if (memory_ == Memory::none) return scratch_ = block_around(voxel_of(points_[point]));
    const Block*& known = block_of_point_[point];
    if (!known) {
      const Voxel voxel = voxel_of(points_[point]);
      auto block = blocks_.find(voxel);
      if (block == blocks_.end()) block = blocks_.emplace(voxel, block_around(voxel)).first;
      known = &block->second;
    }
    return *known;
  }

  NodeIndex nearest(std::size_t point) {
    NodeIndex best = no_node;
    double best_squared = perception_.beyond_reach();
    for (const auto* voxel : block_of(point))
      for (const auto& [node, index] : *voxel) {
        const double squared = squared_distance(points_[point], node.position);
        if (squared > best_squared || (squared == best_squared && index > best)) continue;
        if (!perception_.within_angle(node.position, node.direction, points_[point], squared))
          continue;
        best = index;
        best_squared = squared;
      }
    return best;
  }

  void remove(std::size_t point) {
    dead_[point] = true;
    node_[point] = no_node;
    associated_.erase(static_cast<PointIndex>(point));
    removed_.push_back(static_cast<PointIndex>(point));
    --live_;
  }

  Memory memory_;
  std::span<const Vector3> points_;
  double edge_ = 1.0;
  Perception perception_{1.0, std::numbers::pi};
  std::map<Voxel, std::vector<NumberedNode>> nodes_;  // places in a map stay where they are
  std::map<Voxel, Block> blocks_;
  std::vector<const Block*> block_of_point_;
  Block scratch_{};
  std::vector<bool> dead_;
  std::vector<NodeIndex> node_;
  PointSet associated_;
  std::vector<PointIndex> removed_;
  NodeIndex count_ = 0;
  std::size_t live_ = 0;
  std::int64_t index_computations_ = 0;
};

void record_memory(ExperimentContext& context) {
  for (const char* figure : {"figure-41", "figure-42"}) {
    const Seedling seedling = make_seedling(thesis_tree(figure));
    for (const Memory memory : {Memory::voxels, Memory::none}) {
      context.progress(std::string("voxels of ") + figure);
      CountingVoxels engine(memory);
      const GrowthResult result = grow_crown(seedling, engine);
      const std::string name = std::string("memory/") + figure +
                               (memory == Memory::voxels ? "/remembered/" : "/computed_anew/");
      context.record(name + "tree_hash", tree_hash(result.skeleton));
      context.record(name + "index_computations", engine.index_computations());
    }
  }
}

/// Figure 35 in our own coordinates: a plane of nine voxels and a ring of others around it, a point
/// in the middle one. How many nodes lie in the nine is counted by hand.
void record_plane_scenes(ExperimentContext& context) {
  constexpr int scenes = 1000, nodes_of_a_scene = 40;
  CounterStream stream(context.seed(), 1);
  std::int64_t candidates = 0, in_the_nine = 0, missed = 0, in_own_voxel = 0;
  for (int scene = 0; scene < scenes; ++scene) {
    const std::vector<Vector3> point{
        {stream.next_between(0.01, 0.99), stream.next_between(0.01, 0.99), 0.5}};
    std::vector<SearchableNode> nodes;
    NodeIndex nearest = no_node;
    double least = 1.0;  // of squared distances: the influence distance is 1, too
    for (NodeIndex i = 0; i < nodes_of_a_scene; ++i) {
      const auto within = [&](double cell) { return cell + stream.next_between(0.01, 0.99); };
      const double x = std::floor(stream.next_between(-2, 3)),
                   y = std::floor(stream.next_between(-2, 3));
      nodes.push_back({{within(x), within(y), 0.5}, {0, 1, 0}});
      in_the_nine += std::abs(x) <= 1.0 && std::abs(y) <= 1.0;
      const double squared = squared_distance(point[0], nodes.back().position);
      if (squared <= least && (nearest == no_node || squared < least)) {
        nearest = i;
        least = squared;
      }
    }
    const auto engine = engine_named("voxel_grid").create();
    engine->reset(point,
                  {.influence_distance = 1.0, .perception_half_angle_rad = std::numbers::pi});
    const NodeIndex found = engine->associate(nodes).node[0];
    candidates += static_cast<std::int64_t>(engine->counters().search_evaluations);
    missed += found != nearest;
    if (found == no_node) continue;
    const Vector3& place = nodes[static_cast<std::size_t>(found)].position;
    in_own_voxel += std::floor(place.x) == 0.0 && std::floor(place.y) == 0.0;
  }
  context.record("plane/candidates", candidates, "nodes");
  context.record("plane/nodes_in_nine_voxels", in_the_nine, "nodes");
  context.record("plane/nodes", std::int64_t{scenes} * nodes_of_a_scene, "nodes");
  context.record("plane/missed_nearest", missed, "scenes");
  context.record("plane/nearest_in_own_voxel", in_own_voxel, "scenes");
}

void run(ExperimentContext& context) {
  record_memory(context);
  record_plane_scenes(context);
}

}  // namespace

extern const ExperimentDescriptor voxel_memory;
constinit const ExperimentDescriptor voxel_memory{
    .id = "brzoska2019/voxel-memory",
    .question =
        "Which nodes are candidates in a grid of voxels, and what does it save to remember "
        "voxels and their neighbours?",
    .source = "[Brzoska2019] sec. 5.2.2, fig. 35",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
