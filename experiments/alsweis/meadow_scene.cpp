// SPDX-License-Identifier: MIT
// The scene of section 5.5: a tree, shrubs, a meadow and flowers on 60 m by 60 m.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/population/population.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// Numbers as published; sizes are not.
PopulationParameters scene(std::uint64_t seed, const char* rule) {
  struct Kind {
    const char* name;
    std::int64_t count;
    double root_factor, crown_factor, largest, rate, start;
  };
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.ground = {{0, 0}, {60, 60}};
  parameters.rule = rule;
  for (const Kind& kind :
       {Kind{"tree", 1, 12, 10, 0.4, 0.04, 0.25}, Kind{"shrub", 155, 8, 6, 0.05, 0.005, 0.01},
        Kind{"meadow", 4000, 5, 4, 0.006, 0.0006, 0.0015},
        Kind{"flower", 200, 5, 4, 0.008, 0.0008, 0.0015}}) {
    Species species;
    species.name = kind.name;
    species.count = kind.count;
    species.start_radius_low = species.start_radius_high = kind.start;
    species.largest_radius = kind.largest;
    species.growth_rate = kind.rate;
    species.roots = {kind.root_factor, kind.root_factor, 0.5};
    species.crown = {kind.crown_factor, kind.crown_factor, 0.5};
    parameters.species.push_back(species);
  }
  return parameters;
}

void record_spacing(ExperimentContext& context) {
  std::vector<RunningMoments> spacing(4);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PopulationParameters parameters = scene(context.seed() + seed, "none");
    const PopulationState state = sow(parameters);
    for (std::size_t kind = 1; kind < spacing.size(); ++kind) {
      std::vector<Point2> places;
      for (std::size_t k = 0; k < state.stand.size(); ++k)
        if (state.stand.species[k] == kind) places.push_back(state.stand.place(k));
      for (const double distance : nearest_distances(places, Window::torus(parameters.ground)))
        spacing[kind].add(distance);
    }
  }
  const char* const names[] = {"tree", "shrub", "meadow", "flower"};
  for (std::size_t kind = 1; kind < spacing.size(); ++kind)
    context.record({.experiment = {},
                    .measurement = fmt::format("scene/spacing/{}", names[kind]),
                    .value = spacing[kind].mean(),
                    .unit = "m",
                    .sample_size = static_cast<std::int64_t>(spacing[kind].count()),
                    .seed = context.seed()});
}

void record_scene(ExperimentContext& context) {
  const PopulationParameters parameters = scene(context.seed(), "above_below");
  Population plain(parameters, sow(parameters), overlap_engine_named("layered_grid"));
  const Stand& stand = plain.stand();
  context.record("scene/plants", static_cast<std::int64_t>(stand.size()), "plants");
  context.record("scene/density", static_cast<double>(stand.size()) / parameters.ground.area(),
                 "plants per m^2");
  const std::set<SpeciesIndex> species(stand.species.begin(), stand.species.end());
  context.record("scene/species", static_cast<std::int64_t>(species.size()), "species");
  const auto roots = plain.root_radii(), crowns = plain.crown_radii();
  std::size_t fewest = 99, most = 0;
  for (std::size_t k = 0; k < stand.size(); ++k) {
    const std::size_t circles = std::set{stand.stem_radius[k], roots[k], crowns[k]}.size();
    fewest = std::min(fewest, circles), most = std::max(most, circles);
  }
  context.record("scene/fewest_circles", static_cast<std::int64_t>(fewest), "circles");
  context.record("scene/most_circles", static_cast<std::int64_t>(most), "circles");
  PopulationParameters signed_parameters = scene(context.seed(), "influence_signs");
  signed_parameters.competition.influence_above.assign(16, Influence::harms);
  signed_parameters.competition.influence_below.assign(16, Influence::harms);
  const auto losses = plain.losses(),
             with_signs = Population(signed_parameters, sow(signed_parameters),
                                     overlap_engine_named("layered_grid"))
                              .losses();
  double off = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < losses.size(); ++k)
    sum += losses[k], off = std::max(off, std::abs(losses[k] - with_signs[k]));
  context.record("scene/signs/largest_difference", off);
  context.record("scene/signs/least_loss", *std::min_element(losses.begin(), losses.end()));
  context.record("scene/signs/mean_loss", sum / static_cast<double>(losses.size()));
}

void run(ExperimentContext& context) {
  record_spacing(context);
  record_scene(context);
}

}  // namespace

extern const ExperimentDescriptor meadow_scene;
constinit const ExperimentDescriptor meadow_scene{
    .id = "alsweis/meadow-scene",
    .question = "How dense is the published scene, and what is each of its plants?",
    .source = "[Alsweis] sec. 5.5, fig. 5.7",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
