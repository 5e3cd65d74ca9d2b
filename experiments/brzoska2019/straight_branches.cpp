// SPDX-License-Identifier: MIT
// How far branches turn from edge to edge where they do not branch, for larger and larger influence
// distances: that distance alone, and with all that the thesis' slider changes along with it.
#include <numbers>

#include <fmt/format.h>

#include "core/tree/habit.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

ByTree record_turns(ExperimentContext& context, const std::string& name,
                    const TreeParameters& parameters) {
  return record_trees(context, name + "/mean-turn", "degrees", [&](std::size_t number) {
    const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
    const Skeleton tree = grow_seedling(seedling, context).skeleton;
    return mean_turn_rad(tree, seedling.crown_root) * 180.0 / std::numbers::pi;
  });
}

/// The start settings, but with a kill distance and a density of points that let a crown grow at
/// each of these influence distances.
TreeParameters with_influence_alone(double influence_distance) {
  TreeParameters parameters;
  parameters.influence_distance = influence_distance;
  parameters.kill_distance.begin = parameters.kill_distance.end = 0.3;
  return parameters;
}

/// What the slider sets for a gnarliness, at the branch densities of the start settings.
TreeParameters with_slider_at(double gnarliness) {
  const GnarlinessCoupling coupling = couple_to_gnarliness(gnarliness);
  TreeParameters parameters;
  parameters.influence_distance = coupling.influence_distance;
  parameters.cloud_density = coupling.cloud_density;
  parameters.kill_distance.begin = coupling.kill_distance(0.0);
  parameters.kill_distance.end = coupling.kill_distance(0.8);
  return parameters;
}

void run(ExperimentContext& context) {
  std::vector<std::string> names;
  std::vector<ByTree> alone, slider;
  for (const double gnarliness : {1.0, 0.5, 0.0}) {
    const double distance = couple_to_gnarliness(gnarliness).influence_distance;
    names.push_back(fmt::format("{:.1f}", distance));
    alone.push_back(
        record_turns(context, "influence-alone/" + names.back(), with_influence_alone(distance)));
    slider.push_back(record_turns(context, "slider/" + names.back(), with_slider_at(gnarliness)));
  }
  record_falling(context, "influence-alone", names, alone);
  record_falling(context, "slider", names, slider);
}

}  // namespace

extern const ExperimentDescriptor straight_branches;
constinit const ExperimentDescriptor straight_branches{
    .id = "brzoska2019/straight-branches",
    .question = "Do branches grow straighter the larger the influence distance is?",
    .source = "[Brzoska2019] sec. 3.4.4, fig. 20",
    .seconds = {1.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
