// SPDX-License-Identifier: MIT
// The second scene of chapter 5: a tree that takes light from everybody, large meadow plants that
// take nutrients from small ones and flowers, and nobody else takes anything.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/point_pattern/pair_correlation.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/plant_fates.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 30.0;
constexpr int steps = 30;
enum Kind : SpeciesIndex { the_tree, large, small, flowers, kinds };

constexpr PlantKind large_meadow_plant{"large meadow plant", 9, 4, 0.02, 0.002, 0.008};
constexpr std::int64_t large_count = 60, small_count = 700, flower_count = 100;

/// What is unpublished about the scene.
struct Variant {
  const char* name;
  double above_share;
  double least_growth = 0.01;  ///< of plants that live on, part of the radius per step
  Influence large_on_small = Influence::harms;
};

constexpr std::array variants = {
    Variant{"share-0.5", 0.5}, Variant{"share-0.1", 0.1}, Variant{"share-0.1-hardy", 0.1, 0.002},
    Variant{"share-0.1-without-influence", 0.1, 0.01, Influence::none}};

/// [Alsweis] sec. 5.6; what plants of one kind do to each other is not printed: nothing.
PopulationParameters scene(const Variant& variant, std::uint64_t seed) {
  PopulationParameters parameters = plot_of(side, variant.least_growth, seed);
  parameters.rule = "influence_signs";
  parameters.species = {species_of(tree, 0), species_of(large_meadow_plant, large_count),
                        species_of(meadow_plant, small_count), species_of(flower, flower_count)};
  CompetitionParameters& competition = parameters.competition;
  competition.above_share = variant.above_share;
  competition.influence_above.assign(std::size_t{kinds} * kinds, Influence::none);
  competition.influence_below = competition.influence_above;
  for (const std::size_t victim : {large, small, flowers})
    competition.influence_above[victim * kinds + the_tree] = Influence::harms;
  for (const std::size_t victim : {small, flowers})
    competition.influence_below[victim * kinds + large] = variant.large_on_small;
  return parameters;
}

StartPlant tree_in_the_middle() {
  return in_the_middle_of(side, tree.start_radius);
}

/// Distance to the nearest large meadow plant that lives, in radii of its roots.
double nearness_to_large(const Fates& fates, const Point2& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < fates.size(); ++k)
    if (fates.species[k] == large && fates.radius[k] > 0.0)
      nearest =
          std::min(nearest, norm(fates.place[k] - place) /
                                zone_radius_of(large_meadow_plant.root_factor, fates.radius[k]));
  return nearest;
}

/// Small meadow plants and flowers of one plot: inside the zones of large plants, and clear of
/// them; the same beyond the tree's crown.
struct Parts {
  Tally inside, outside, lit_inside, lit_outside;
  double large_survival = 0.0, clark_evans_start = 0.0, clark_evans_end = 0.0;
  double mixing_start = 0.0, mixing_end = 0.0;
};

std::vector<Point2> living(const Fates& fates, bool is_large) {
  std::vector<Point2> places;
  for (std::size_t k = 0; k < fates.size(); ++k)
    if (fates.species[k] != the_tree && (fates.species[k] == large) == is_large &&
        fates.radius[k] > 0.0)
      places.push_back(fates.place[k]);
  return places;
}

/// Pair correlation of large and small plants at half a metre: 1 if they do not care.
double mixing(const Fates& fates, const Window& window) {
  const std::array<double, 1> distance = {0.5};
  return cross_pair_correlation(living(fates, true), living(fates, false), window, distance,
                                {.correction = EdgeCorrection::translation, .half_width = 0.3})[0];
}

/// Adds what became of the small plants to the part that they stand in.
void tally_small(const Fates& fates, Parts& parts) {
  const Point2 the_stem = fates.place[0];
  const double crown = zone_radius_of(tree.crown_factor, fates.radius[0]);
  for (std::size_t k = 1; k < fates.size(); ++k) {
    if (fates.species[k] == large) continue;
    const double nearness = nearness_to_large(fates, fates.place[k]);
    if (nearness >= 0.9 && nearness <= 1.3) continue;
    (nearness < 0.9 ? parts.inside : parts.outside).add(fates, k);
    if (norm(fates.place[k] - the_stem) > crown + 1.0)
      (nearness < 0.9 ? parts.lit_inside : parts.lit_outside).add(fates, k);
  }
}

Parts parts_of(const Variant& variant, std::uint64_t seed) {
  const StartPlant in_the_middle = tree_in_the_middle();
  Population population = population_of(scene(variant, seed), {&in_the_middle, 1});
  const Window window = Window::rectangle(population.parameters().ground);
  Fates fates = fates_at_start(population.stand());
  Parts parts;
  parts.clark_evans_start = clark_evans(living(fates, true), window).ratio;
  parts.mixing_start = mixing(fates, window);
  for (int t = 0; t < steps; ++t) population.step();
  update_fates(population.stand(), fates);
  parts.clark_evans_end = clark_evans(living(fates, true), window).ratio;
  parts.mixing_end = mixing(fates, window);
  parts.large_survival = static_cast<double>(living(fates, true).size()) / large_count;
  tally_small(fates, parts);
  return parts;
}

template <class Value>
std::vector<double> of_all(const std::vector<Parts>& plots, const Value& value) {
  std::vector<double> values;
  for (const Parts& parts : plots) values.push_back(value(parts));
  return values;
}

void record_groups(ExperimentContext& context, const std::string& group,
                   const std::vector<Parts>& plots) {
  const auto start = of_all(plots, [](const Parts& p) { return p.clark_evans_start; });
  const auto end = of_all(plots, [](const Parts& p) { return p.clark_evans_end; });
  const std::vector<double> at_random(plots.size(), 1.0);
  record_mean(context, group + "/large/survival",
              of_all(plots, [](const Parts& p) { return p.large_survival; }));
  record_mean(context, group + "/large/clark_evans_start", start);
  record_mean(context, group + "/large/clark_evans_end", end);
  record_order(context, group + "/large/random_over_clark_evans_end", at_random, end);
  record_order(context, group + "/large/start_over_end_clark_evans", start, end);
  const auto mixed = of_all(plots, [](const Parts& p) { return p.mixing_start; });
  const auto mixed_at_end = of_all(plots, [](const Parts& p) { return p.mixing_end; });
  record_mean(context, group + "/mixing_at_half_a_metre/start", mixed);
  record_mean(context, group + "/mixing_at_half_a_metre/end", mixed_at_end);
  record_order(context, group + "/mixing_at_half_a_metre/start_over_end", mixed, mixed_at_end);
}

void record_variant(ExperimentContext& context, const Variant& variant) {
  const std::size_t seeds = context.tier() == Tier::full ? 200 : 20;
  std::vector<Parts> plots(seeds);
  for_runs(context, variant.name, seeds, [&](std::size_t run) {
    plots[run] = parts_of(variant, seed_of_run(context, question_influence, run));
  });
  Parts all;
  for (const Parts& parts : plots) {
    all.inside += parts.inside;
    all.outside += parts.outside;
    all.lit_inside += parts.lit_inside;
    all.lit_outside += parts.lit_outside;
  }
  const std::string group = variant.name;
  record_tally(context, group + "/inside", all.inside);
  record_tally(context, group + "/outside", all.outside);
  record_tally(context, group + "/beyond-crown/inside", all.lit_inside);
  record_tally(context, group + "/beyond-crown/outside", all.lit_outside);
  record_order(context, group + "/survival_outside_over_inside",
               of_all(plots, [](const Parts& p) { return p.outside.survival(); }),
               of_all(plots, [](const Parts& p) { return p.inside.survival(); }));
  record_order(context, group + "/beyond-crown/survival_outside_over_inside",
               of_all(plots, [](const Parts& p) { return p.lit_outside.survival(); }),
               of_all(plots, [](const Parts& p) { return p.lit_inside.survival(); }));
  record_groups(context, group, plots);
}

StandPanel stage_panel(const Population& population) {
  StandPanel panel{.layers = {stems_of(population, small), stems_of(population, flowers),
                              root_zones_of(population, large), stems_of(population, large),
                              crown_zones_of(population, the_tree), stems_of(population, the_tree)},
                   .caption = fmt::format("share of light {}, step {}",
                                          population.parameters().competition.above_share,
                                          population.state().step)};
  constexpr std::array<std::size_t, 6> colours = {6, 7, 4, 4, 2, 2};
  for (std::size_t k = 0; k < colours.size(); ++k) panel.layers[k].colour = colours[k];
  panel.layers[0].name = "small meadow plant";
  return panel;
}

void draw_scene(ExperimentContext& context) {
  const StartPlant in_the_middle = tree_in_the_middle();
  std::vector<StandPanel> panels;
  for (const Variant& variant : {variants[1], variants[0]}) {
    Population population = population_of(
        scene(variant, seed_of_run(context, question_influence, 0)), {&in_the_middle, 1});
    const bool is_first = panels.empty();
    for (const int stage : {0, 12, steps}) {
      while (population.state().step < stage) population.step();
      if (is_first || stage == steps) panels.push_back(stage_panel(population));
    }
  }
  context.artifact(
      "figure-5.8.svg",
      stand_panels_svg({.ground = {{0.0, 0.0}, {side, side}}, .columns = 4, .panel_width = 230.0},
                       panels,
                       "Figure 5.8: a tree that takes light only, large meadow plants that take "
                       "nutrients only, and small plants that take nothing"));
}

void run(ExperimentContext& context) {
  for (const Variant& variant : variants) record_variant(context, variant);
  draw_scene(context);
}

}  // namespace

extern const ExperimentDescriptor influence_matrix;
constinit const ExperimentDescriptor influence_matrix{
    .id = "alsweis/influence-matrix",
    .question = "Do large meadow plants form groups in which small plants die?",
    .source = "[Alsweis] sec. 5.6, figure 5.8",
    .seconds = {1, 1, 4},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
