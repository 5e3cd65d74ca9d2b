// SPDX-License-Identifier: MIT
// How often growth stops before its last iteration although most points are left, when that
// happens, and whether the next seed grows.
#include <algorithm>

#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Stops {
  std::int64_t trees = 0;
  std::int64_t stopped = 0;      ///< before the last iteration
  std::int64_t with_points = 0;  ///< of these, with more than three quarters of the points left
  std::int64_t early = 0;        ///< with points, in the first half of the iterations
  std::int64_t cured = 0;        ///< with points, and the next seed does not stop
  std::int64_t latest = 0;       ///< iterations that the last of them executed
};

GrowthResult grow_with_seed(const TreeParameters& parameters, std::size_t number,
                            const ExperimentContext& context, double& share_left) {
  const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
  GrowthResult result = grow_seedling(seedling, context);
  share_left = static_cast<double>(result.live_points) /
               static_cast<double>(seedling.attraction_points.size());
  return result;
}

void record_stops(ExperimentContext& context, const std::string& name,
                  const TreeParameters& parameters, std::size_t trees) {
  context.progress(name);
  Stops stops;
  bool last_stopped = false;  // with points left
  for (std::size_t number = 0; number < trees; ++number) {
    double share_left = 0.0;
    const GrowthResult result = grow_with_seed(parameters, number, context, share_left);
    const bool stopped = result.stop_reason != StopReason::iteration_limit;
    const auto executed = static_cast<std::int64_t>(result.passes.size());
    ++stops.trees;
    stops.stopped += stopped;
    stops.cured += last_stopped && !stopped;
    last_stopped = stopped && share_left > 0.75;
    if (!last_stopped) continue;
    ++stops.with_points;
    stops.early += 2 * executed <= parameters.iterations;
    stops.latest = std::max(stops.latest, executed);
  }
  const auto record = [&](const char* what, std::int64_t value, const char* unit) {
    context.record({.experiment = {},
                    .measurement = name + what,
                    .value = value,
                    .unit = unit,
                    .sample_size = stops.trees,
                    .seed = context.seed()});
  };
  record("/trees", stops.trees, "trees");
  record("/stopped", stops.stopped, "trees");
  record("/stopped-with-points-left", stops.with_points, "trees");
  record("/stopped-in-first-half", stops.early, "trees");
  // The last tree has no next seed here.
  record("/stopped-and-reseeded", stops.with_points - last_stopped, "trees");
  record("/next-seed-grows", stops.cured, "trees");
  record("/latest-stop", stops.latest, "iterations");
}

void run(ExperimentContext& context) {
  const TreeParameters start_settings;
  record_stops(context, "start-settings", start_settings, 300);
  TreeParameters sparse = start_settings;
  sparse.cloud_density *= 0.75;
  record_stops(context, "three-quarters-of-the-points", sparse, 150);
}

}  // namespace

extern const ExperimentDescriptor sudden_stop;
constinit const ExperimentDescriptor sudden_stop{
    .id = "brzoska2019/sudden-stop",
    .question = "How often does growth stop although most points are left?",
    .source = "[Brzoska2019] sec. 6.2",
    .seconds = {1.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
