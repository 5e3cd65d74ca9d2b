// SPDX-License-Identifier: MIT
// Few large plants among many small ones: where the small ones can live. And whether plants of two
// species do all that plants do.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/alsweis/stand_panels.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t seeds = 20;
constexpr int steps = 50;
constexpr SpeciesIndex large = 0, small = 1;

/// Distances to the nearest large plant, in radii of its zone.
constexpr double near_below = 0.8, far_beyond = 1.2;

struct Mixture {
  const char* name;
  const char* rule;
  double asymmetric_share = 0.0;
};
constexpr std::array mixtures = {Mixture{"none", "none"}, Mixture{"symmetric", "mixture", 0.0},
                                 Mixture{"half", "mixture", 0.5},
                                 Mixture{"asymmetric", "mixture", 1.0}};

PopulationParameters large_and_small(const Mixture& mixture, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = mixture.rule;
  parameters.competition.above_share = mixture.asymmetric_share;
  parameters.ground = {{0.0, 0.0}, {120.0, 120.0}};
  parameters.is_torus = false;
  parameters.species = {{.name = "large plant",
                         .count = 12,
                         .start_radius_low = 0.8 * 0.3,
                         .start_radius_high = 1.2 * 0.3},
                        {.name = "small plant",
                         .count = 250,
                         .start_radius_low = 0.8 * 0.02,
                         .start_radius_high = 1.2 * 0.02,
                         .largest_radius = 0.1,
                         .growth_rate = 0.01,
                         .roots = {.poor_factor = 8.0, .rich_factor = 8.0}}};
  parameters.mortality = {
      .rule = MortalityRule::mean_relative_growth, .threshold = 0.004, .grown_up = 0.9};
  return parameters;
}

struct SmallPlant {
  Point2 place;
  double distance = std::numeric_limits<double>::infinity();  ///< in radii of a large one's zone
  bool is_alive = false;
};

/// All small plants that were sown, and their distances to those large ones that are left.
std::vector<SmallPlant> small_plants(const PopulationParameters& parameters,
                                     const Population& end) {
  const Stand& stand = end.stand();
  const std::vector<double> zones = end.root_radii();
  std::set<PlantId> alive(stand.id.begin(), stand.id.end());
  const Stand start = sow(parameters).stand;
  std::vector<SmallPlant> plants;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (start.species[i] != small) continue;
    SmallPlant plant{.place = start.place(i), .is_alive = alive.contains(start.id[i])};
    for (std::size_t k = 0; k < stand.size(); ++k)
      if (stand.species[k] == large)
        plant.distance = std::min(plant.distance,
                                  std::sqrt(squared_norm(plant.place - stand.place(k))) / zones[k]);
    plants.push_back(plant);
  }
  return plants;
}

/// Which part of the small plants lives between two distances; NaN if there were none.
double survival(const std::vector<SmallPlant>& plants, double from, double to) {
  double alive = 0.0, all = 0.0;
  for (const SmallPlant& plant : plants)
    if (plant.distance >= from && plant.distance < to) {
      all += 1.0;
      alive += plant.is_alive ? 1.0 : 0.0;
    }
  return alive / all;
}

using Runs = std::vector<std::vector<SmallPlant>>;

Runs runs_of(ExperimentContext& context, const Mixture& mixture) {
  Runs runs(seeds);
  for_runs(context, mixture.name, seeds, [&](std::size_t s) {
    const PopulationParameters parameters =
        large_and_small(mixture, seed_of_run(context, Question::near_and_far, s));
    runs[s] = small_plants(parameters, lived(parameters, steps));
  });
  return runs;
}

void record_survival(ExperimentContext& context, const Mixture& mixture, const Runs& runs) {
  std::vector<double> near, far;
  for (const auto& plants : runs) {
    near.push_back(survival(plants, 0.0, near_below));
    far.push_back(survival(plants, far_beyond, std::numeric_limits<double>::infinity()));
  }
  const std::string group = fmt::format("survival/{}", mixture.name);
  record_mean(context, group + "/near", near);
  record_mean(context, group + "/far", far);
  context.record(group + "/largest_near", *std::max_element(near.begin(), near.end()));
  record_paired(context, group + "/far_over_near", far, near);
}

/// Figure 4.9 in numbers: of all runs together, which part lives how far from a large plant.
void draw_survival(ExperimentContext& context, const std::vector<Runs>& all) {
  PlotPanel panel{.caption = "12 large among 250 small plants, 20 seeds",
                  .x_label = "distance to the nearest large plant, radii of its zone",
                  .y_label = "small plants alive after 50 steps",
                  .x_range = AxisRange{0.0, 2.5},
                  .y_range = AxisRange{0.0, 1.0}};
  for (std::size_t k = 0; k < mixtures.size(); ++k) {
    std::vector<SmallPlant> plants;
    for (const auto& some : all[k]) plants.insert(plants.end(), some.begin(), some.end());
    PlotCurve curve{.name = mixtures[k].name};
    constexpr double width = 0.1;
    for (int cell = 0; cell < 25; ++cell) {
      curve.x.push_back((cell + 0.5) * width);
      curve.y.push_back(survival(plants, cell * width, (cell + 1) * width));
    }
    panel.curves.push_back(curve);
  }
  add_plot(context, "figure-4.9",
           {.title = "Figure 4.9 in numbers: small plants near large ones",
            .description = "Share of the small plants that live after 50 steps, over the distance "
                           "to the nearest large plant in radii of its zone.",
            .panels = {panel}});
}

/// Figure 4.4: the same plants without competition, and with either kind.
void draw_maps(ExperimentContext& context) {
  std::vector<StandPanel> panels;
  for (const auto& [mixture, caption] :
       {std::pair{mixtures[0], "a) without competition"}, std::pair{mixtures[1], "b) symmetric"},
        std::pair{mixtures[3], "c) asymmetric"}}) {
    const PopulationParameters parameters =
        large_and_small(mixture, seed_of_run(context, Question::near_and_far, 0));
    const Population end = lived(parameters, steps);
    StandLayer dead{.name = "small plant that died", .places = {}, .radii = {}};
    for (const SmallPlant& plant : small_plants(parameters, end))
      if (!plant.is_alive) {
        dead.places.push_back(plant.place);
        dead.radii.push_back(0.0);
      }
    // Stems thicker than they are, so that one sees them.
    panels.push_back({.layers = {root_zones_of(end, large), stems_of(end, large, 5.0), dead,
                                 stems_of(end, small, 10.0)},
                      .caption = caption});
  }
  const PopulationParameters parameters = large_and_small(mixtures[0], 0);
  context.artifact("figure-4.4.svg",
                   stand_panels_svg({.ground = parameters.ground}, panels,
                                    "Figure 4.4: small plants without and with competition"));
}

void record_small_among_large(ExperimentContext& context) {
  std::vector<Runs> all;
  for (const Mixture& mixture : mixtures) {
    all.push_back(runs_of(context, mixture));
    record_survival(context, mixture, all.back());
  }
  draw_survival(context, all);
  draw_maps(context);
}

/// Both species with seeds, on a grey map as sec. 4.2 wants it: rich in the west, poor in the east.
PopulationParameters with_seeds(bool is_torus, std::uint64_t seed) {
  PopulationParameters parameters = large_and_small(mixtures[2], seed);
  parameters.is_torus = is_torus;
  parameters.nutrients = ResourceMap(3, 1, {1.0, 0.5, 0.0}, parameters.ground);
  for (Species& species : parameters.species) {
    species.roots.rich_factor = 0.6 * species.roots.poor_factor;
    species.reproduction = {.threshold = 0.5 * species.largest_radius,
                            .seeds_per_metre = 0.5 / species.largest_radius,
                            .seedling_radius = 0.2 * species.largest_radius};
  }
  return parameters;
}

/// What happens in 60 steps, and what must not.
struct Events {
  std::int64_t grown = 0, born = 0, died = 0, steps_with_all = 0;
  std::int64_t repeated_ids = 0, outside = 0, unaccounted = 0;
};

/// One step; `radius` holds every plant of the step before.
void count_step(Population& population, std::map<PlantId, double>& radius, Events& events) {
  const PlantId first_new = population.state().next_id;
  population.step();
  const Stand& stand = population.stand();
  std::map<PlantId, double> now;
  std::int64_t grown = 0, born = 0;
  for (std::size_t i = 0; i < stand.size(); ++i) {
    events.repeated_ids += now.emplace(stand.id[i], stand.stem_radius[i]).second ? 0 : 1;
    events.outside += population.parameters().ground.contains(stand.place(i)) ? 0 : 1;
    const auto before = radius.find(stand.id[i]);
    // A plant that was not there before must have an id that never was.
    if (before == radius.end()) {
      ++born;
      events.repeated_ids += stand.id[i] < first_new ? 1 : 0;
    } else {
      grown += stand.stem_radius[i] > before->second ? 1 : 0;
    }
  }
  const auto died = static_cast<std::int64_t>(radius.size() + static_cast<std::size_t>(born)) -
                    static_cast<std::int64_t>(now.size());
  events.grown += grown;
  events.born += born;
  events.died += died;
  events.steps_with_all += grown > 0 && born > 0 && died > 0 ? 1 : 0;
  radius = std::move(now);
}

void record_events(ExperimentContext& context, bool is_torus) {
  Population population =
      population_of(with_seeds(is_torus, seed_of_run(context, Question::all_events, 0)));
  std::map<PlantId, double> radius;
  for (std::size_t i = 0; i < population.stand().size(); ++i)
    radius[population.stand().id[i]] = population.stand().stem_radius[i];
  const auto start = static_cast<std::int64_t>(radius.size());
  Events events;
  for (int t = 0; t < 60; ++t) count_step(population, radius, events);
  std::int64_t died = 0;
  for (const std::uint64_t number : population.state().died)
    died += static_cast<std::int64_t>(number);
  events.unaccounted =
      start + events.born - died - static_cast<std::int64_t>(population.stand().size());
  const std::string group = is_torus ? "events/torus" : "events/border";
  context.record(group + "/grown", events.grown, "plant steps");
  context.record(group + "/born", events.born, "plants");
  context.record(group + "/died", events.died, "plants");
  context.record(group + "/steps_with_all_three", events.steps_with_all, "steps");
  context.record(group + "/repeated_ids", events.repeated_ids, "plants");
  context.record(group + "/outside", events.outside, "plant steps");
  context.record(group + "/unaccounted", events.unaccounted, "plants");
}

void run(ExperimentContext& context) {
  record_small_among_large(context);
  record_events(context, true);
  record_events(context, false);
}

}  // namespace

extern const ExperimentDescriptor two_species;
constinit const ExperimentDescriptor two_species{
    .id = "alsweis/two-species",
    .question = "Where can small plants live among large ones, and do plants live, bear and die?",
    .source = "[Alsweis] sec. 4.2, 4.7, figures 4.4 and 4.9",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
