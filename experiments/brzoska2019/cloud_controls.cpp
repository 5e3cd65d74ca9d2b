// SPDX-License-Identifier: MIT
// Two things that the thesis says of its cloud and that a tree must show: what a fixed number of
// points does to a crown that is made larger, and that used points may be flagged as well as
// erased.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// A crown that is full long before the last iteration, under one kill distance, so that nothing
/// but its points says how densely it branches.
TreeParameters small_crown() {
  TreeParameters parameters;
  parameters.cloud.radii = {2.5, 3.5, 2.25};
  parameters.iterations = 200;
  parameters.kill_distance.begin = parameters.kill_distance.end = 0.4;
  parameters.tropism_damping = TropismDamping::none;
  return parameters;
}

/// All three axes longer, so that its shape stays and its volume doubles.
void double_volume(TreeParameters& parameters) {
  constexpr double cube_root_of_2 = 1.2599210498948731648;  // std::cbrt: not the same everywhere
  parameters.cloud.radii = cube_root_of_2 * parameters.cloud.radii;
}

double branchings_per_volume(const TreeParameters& parameters) {
  const auto engine = engine_named("voxel_grid").create();
  const Skeleton tree = grow_crown(make_seedling(parameters), *engine).skeleton;
  const ChildLists children(tree);
  std::size_t branchings = 0;
  for (std::size_t node = 0; node < tree.node_count(); ++node)
    branchings += children.of(static_cast<std::int32_t>(node)).size() > 1;
  return static_cast<double>(branchings) / volume(parameters.cloud);
}

void record_larger_crowns(ExperimentContext& context) {
  constexpr std::uint64_t seeds = 10;
  double usual = 0.0, fixed_number = 0.0, fixed_density = 0.0;
  std::int64_t fewer = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    context.progress(fmt::format("crowns of two sizes, seed {} of {}", seed, seeds));
    TreeParameters parameters = small_crown();
    parameters.seed = context.seed() + seed;
    const double small = branchings_per_volume(parameters);
    double_volume(parameters);
    const double as_dense = branchings_per_volume(parameters);
    parameters.cloud_density /= 2.0;
    const double as_many = branchings_per_volume(parameters);
    usual += small / seeds;
    fixed_density += as_dense / seeds;
    fixed_number += as_many / seeds;
    fewer += as_many < small;
  }
  const auto record = [&](const char* name, RecordValue value, const char* unit) {
    context.record({.experiment = {},
                    .measurement = std::string("larger-crown/") + name,
                    .value = std::move(value),
                    .unit = unit,
                    .sample_size = seeds,
                    .seed = context.seed()});
  };
  record("usual/branchings", usual, "per volume");
  record("fixed-density/branchings", fixed_density, "per volume");
  record("fixed-number/branchings", fixed_number, "per volume");
  record("fixed-number/fewer_than_usual", fewer, "trees");
}

enum class Used { flagged, erased };

/// Each live point keeps its nearest node and is shown the new ones alone. Used points are passed
/// over, or taken out of the list so that those behind them move up.
class ListOfPoints final : public NearestNodeEngine {
 public:
  explicit ListOfPoints(Used used) : used_(used) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    perception_ = Perception(setup.influence_distance, setup.perception_half_angle_rad);
    entries_.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
      entries_.push_back(
          {static_cast<PointIndex>(i), points[i], false, perception_.beyond_reach()});
    live_ = points.size();
    nodes_ = 0;
    node_.assign(points.size(), no_node);
    associated_.reset(points.size());
    work_ = {};
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    for (const SearchableNode& node : new_nodes) {
      for (Entry& entry : entries_) show(node, entry);
      ++nodes_;
    }
    return {node_, associated_};
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override {
    removed_.clear();
    for (Entry& entry : entries_)
      for (const SearchableNode& killer : killers)
        if (!entry.used &&
            squared_distance(entry.position, killer.position) <= kill_distance * kill_distance)
          remove(entry);
    if (used_ == Used::erased)
      std::erase_if(entries_, [](const Entry& entry) { return entry.used; });
    return removed_;
  }

  std::size_t live_points() const override { return live_; }
  WorkCounters counters() const override { return work_; }

 private:
  struct Entry {
    PointIndex point;
    Vector3 position;
    bool used;
    double squared;  ///< distance to its nearest node
  };

  void show(const SearchableNode& node, Entry& entry) {
    if (entry.used) return;
    const double squared = squared_distance(entry.position, node.position);
    ++work_.search_evaluations;
    if (!(squared < entry.squared) ||
        !perception_.within_angle(node.position, node.direction, entry.position, squared))
      return;
    entry.squared = squared;
    node_[static_cast<std::size_t>(entry.point)] = nodes_;
    associated_.insert(entry.point);
  }

  void remove(Entry& entry) {
    entry.used = true;
    node_[static_cast<std::size_t>(entry.point)] = no_node;
    associated_.erase(entry.point);
    removed_.push_back(entry.point);
    --live_;
  }

  Used used_;
  Perception perception_{1.0, std::numbers::pi};
  std::vector<Entry> entries_;
  std::size_t live_ = 0;
  NodeIndex nodes_ = 0;
  std::vector<NodeIndex> node_;
  PointSet associated_;
  std::vector<PointIndex> removed_;
  WorkCounters work_;
};

void record_used_points(ExperimentContext& context) {
  for (const char* figure : {"figure-40", "figure-41", "figure-42"}) {
    context.progress(std::string("flagged and erased points of ") + figure);
    const Seedling seedling = make_seedling(thesis_tree(figure));
    for (const Used used : {Used::flagged, Used::erased}) {
      ListOfPoints engine(used);
      const GrowthResult result = grow_crown(seedling, engine);
      const std::string name =
          fmt::format("used-points/{}/{}/", figure, used == Used::flagged ? "flagged" : "erased");
      context.record(name + "tree_hash", tree_hash(result.skeleton));
      context.record(name + "edges", static_cast<std::int64_t>(result.skeleton.edge_count()),
                     "edges");
    }
  }
}

void run(ExperimentContext& context) {
  record_larger_crowns(context);
  record_used_points(context);
}

}  // namespace

extern const ExperimentDescriptor cloud_controls;
constinit const ExperimentDescriptor cloud_controls{
    .id = "brzoska2019/cloud-controls",
    .question =
        "What does a fixed number of points do to a larger crown, and does it matter how "
        "used points are kept?",
    .source = "[Brzoska2019] sec. 5.2.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
