// SPDX-License-Identifier: MIT
// Sec. 6.1.1 wishes for better comparisons of positions between influence points and nodes. What do
// spatial indices save, and is the tree the same?
#include "experiments/liebemann2017/limited_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// Engines that every build has.
constexpr const char* engines[] = {"euclidean_scan", "squared_scan", "sorted_axes", "voxel_grid",
                                   "node_driven"};

void run(ExperimentContext& context) {
  const Seedling seedling = without_repeats(
      scene(cloud(round_region(RoundShape::disc, ring_radius), ring_points, context.seed(), 700),
            {0, -ring_radius, 0}));
  const GrowthResult scanned = grow(seedling);
  const auto all = static_cast<double>(scanned.work.search_evaluations);
  for (const std::string name : engines) {
    const auto engine = engine_named(name).create();
    const GrowthResult result = grow_crown(seedling, *engine);
    record_seeded(context, name + "/other_tree",
                  std::int64_t{tree_hash(result.skeleton) != tree_hash(scanned.skeleton)});
    record_seeded(context, name + "/share_of_distances",
                  static_cast<double>(result.work.search_evaluations) / all);
  }
}

}  // namespace

extern const ExperimentDescriptor position_queries;
constinit const ExperimentDescriptor position_queries{
    .id = "liebemann2017/position-queries",
    .question = "How many comparisons of positions can a spatial index save?",
    .source = "[Liebemann2017] sec. 6.1.1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
