// SPDX-License-Identifier: MIT
// Figures 7.6 and 7.7: small plants below a tree that lets light through, and below one that does
// not. Who grows there, and how that hangs on the constant k of (7.1), which is not printed.
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/competition/zone_laws.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/plant_fates.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 24.0, least_growth = 0.002;
/// The tree is grown up: its rings stay where they are.
const double crown_radius = zone_radius_of(tree.crown_factor, tree.largest_radius);
constexpr int steps = 25;
/// As dense as in sec. 5.5, which has no number for this scene.
constexpr std::int64_t meadow_count = 640, flower_count = 32;

/// L / q of (7.2), corrected: what the crown keeps of the light that it does not share.
struct Crown {
  const char* name;
  double opacity;
};
constexpr std::array crowns = {Crown{"open", 0.0}, Crown{"dense", 1.0}};

/// What (7.1) and (7.5) leave open, and whether small plants take anything from each other.
struct Setting {
  double light_constant, above_share;
  Influence small_on_small = Influence::none;

  std::string name() const {
    return fmt::format("k-{}/share-{}{}", light_constant, above_share,
                       small_on_small == Influence::harms ? "/crowded" : "");
  }
};

/// 3 is the constant of (5.3), 2.5 the least that lets no light through a dense crown anywhere.
constexpr std::array settings = {Setting{1, 1},
                                 Setting{1, 0.5},
                                 Setting{2.5, 1},
                                 Setting{2.5, 0.5},
                                 Setting{3, 1},
                                 Setting{3, 0.5},
                                 Setting{1, 1, Influence::harms},
                                 Setting{3, 1, Influence::harms}};

PopulationParameters scene(const Setting& setting, const Crown& crown, std::uint64_t seed) {
  PopulationParameters parameters = plot_of(side, least_growth, seed);
  parameters.rule = "combined";
  parameters.species = {species_of(tree, 0), species_of(meadow_plant, meadow_count),
                        species_of(flower, flower_count)};
  // Roots that are all flat share as in (5.1).
  for (Species& species : parameters.species) species.traits = {.root_rank = 0.0};
  parameters.species[0].traits.crown_opacity = crown.opacity;
  CompetitionParameters& competition = parameters.competition;
  competition.light_constant = setting.light_constant;
  competition.above_share = setting.above_share;
  const Influence small = setting.small_on_small;
  competition.influence_above = {Influence::harms,
                                 Influence::harms,
                                 Influence::harms,
                                 Influence::harms,
                                 small,
                                 small,
                                 Influence::harms,
                                 small,
                                 small};
  competition.influence_below = competition.influence_above;
  return parameters;
}

StartPlant tree_in_the_middle() {
  return in_the_middle_of(side, tree.largest_radius);
}

/// Small plants by F, the ring of the tree's crown that they reach into at the start, and those
/// that never reach it. Plants across the rim of the crown are left out.
struct Rings {
  std::array<Tally, 5> ring;
  Tally outside;

  Tally below() const {
    Tally all;
    for (const Tally& tally : ring) all += tally;
    return all;
  }
};

Rings rings_of(const Setting& setting, const Crown& crown, std::uint64_t seed) {
  const StartPlant the_tree = tree_in_the_middle();
  Population population = population_of(scene(setting, crown, seed), {&the_tree, 1});
  Fates fates = fates_at_start(population.stand());
  for (int t = 0; t < steps; ++t) population.step();
  update_fates(population.stand(), fates);
  const double reach = zone_radius_of(flower.crown_factor, flower.largest_radius);
  Rings rings;
  for (std::size_t k = 1; k < fates.size(); ++k) {
    const double distance = norm(fates.place[k] - the_tree.place);
    const double own = zone_radius_of(flower.crown_factor, fates.start_radius[k]);
    if (distance + reach < crown_radius)
      rings.ring.at(static_cast<std::size_t>(zone_index(distance, own, crown_radius) - 1))
          .add(fates, k);
    else if (distance - reach > crown_radius)
      rings.outside.add(fates, k);
  }
  return rings;
}

std::vector<double> survival_below(const std::vector<Rings>& plots) {
  std::vector<double> values;
  for (const Rings& rings : plots) values.push_back(rings.below().survival());
  return values;
}

std::vector<double> survival_outside(const std::vector<Rings>& plots) {
  std::vector<double> values;
  for (const Rings& rings : plots) values.push_back(rings.outside.survival());
  return values;
}

void record_setting(ExperimentContext& context, const Setting& setting) {
  const std::size_t seeds = context.tier() == Tier::full ? 100 : 20;
  std::array<std::vector<Rings>, crowns.size()> plots;
  for (std::size_t c = 0; c < crowns.size(); ++c) {
    plots[c].resize(seeds);
    for_runs(context, fmt::format("{}, {}", setting.name(), crowns[c].name), seeds,
             [&](std::size_t run) {
               plots[c][run] =
                   rings_of(setting, crowns[c], seed_of_run(context, question_light, run));
             });
    Rings all;
    for (const Rings& rings : plots[c]) {
      for (std::size_t ring = 0; ring < all.ring.size(); ++ring) all.ring[ring] += rings.ring[ring];
      all.outside += rings.outside;
    }
    const std::string group = fmt::format("{}/{}", setting.name(), crowns[c].name);
    record_tally(context, group + "/below", all.below());
    record_tally(context, group + "/outside", all.outside);
    for (std::size_t ring = 0; ring < all.ring.size(); ++ring)
      context.record(fmt::format("{}/ring-{}/survival", group, ring + 1),
                     all.ring[ring].survival());
    record_order(context, group + "/survival_outside_over_below", survival_outside(plots[c]),
                 survival_below(plots[c]));
  }
  record_order(context, setting.name() + "/survival_below_open_over_dense",
               survival_below(plots[0]), survival_below(plots[1]));
}

/// The tree's crown, and small plants as large as theirs.
StandPanel panel_of(const Population& population, const std::string& caption) {
  StandPanel panel{.layers = {crown_zones_of(population, 1), crown_zones_of(population, 2),
                              crown_zones_of(population, 0), stems_of(population, 0)},
                   .caption = caption};
  for (const std::size_t small : {0u, 1u}) panel.layers[small].mark = StandMark::disc;
  panel.layers[0].name = "crown of a meadow plant";
  panel.layers[1].name = "crown of a flower";
  panel.layers[2].name = "crown of the tree";
  panel.layers[3].name = "";
  constexpr std::array<std::size_t, 4> colours = {6, 7, 2, 2};
  for (std::size_t k = 0; k < colours.size(); ++k) panel.layers[k].colour = colours[k];
  return panel;
}

void draw_crowns(ExperimentContext& context) {
  const StartPlant the_tree = tree_in_the_middle();
  const std::uint64_t seed = seed_of_run(context, question_light, 0);
  std::vector<StandPanel> panels;
  for (const double k : {1.0, 2.5}) {
    for (const Crown& crown : crowns) {
      Population population = population_of(scene({k, 1.0}, crown, seed), {&the_tree, 1});
      if (panels.empty()) panels.push_back(panel_of(population, "at the start"));
      for (int t = 0; t < steps; ++t) population.step();
      panels.push_back(panel_of(population, fmt::format("{} tree, k = {}", crown.name, k)));
    }
  }
  context.artifact(
      "figures-7.6-7.7.svg",
      stand_panels_svg({.ground = {{0.0, 0.0}, {side, side}}, .columns = 5, .panel_width = 220.0},
                       panels,
                       "Figures 7.6 and 7.7: small plants around an open and a dense "
                       "tree after 25 steps"));
}

void run(ExperimentContext& context) {
  for (const Setting& setting : settings) record_setting(context, setting);
  draw_crowns(context);
}

}  // namespace

extern const ExperimentDescriptor light_and_crowns;
constinit const ExperimentDescriptor light_and_crowns{
    .id = "alsweis/light-and-crowns",
    .question = "Do small plants grow below an open tree, and not below a dense one?",
    .source = "[Alsweis] sec. 7.2, 7.6, figures 7.6 and 7.7",
    .seconds = {1, 1, 4},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
