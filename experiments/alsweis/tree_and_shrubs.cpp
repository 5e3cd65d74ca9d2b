// SPDX-License-Identifier: MIT
// The scene of figure 5.7: a tree, shrubs, meadow and flowers on 60 m x 60 m. What the tree does to
// the shrubs around it, whether by its roots or by its crown, and how numbers fall.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/plant_fates.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 60.0, least_growth = 0.002;
constexpr int steps = 25;
constexpr double margin = 2.0;  ///< beyond the tree's zone a shrub counts as far from it, m
constexpr std::size_t kinds = 4;
constexpr std::array<std::int64_t, kinds> counts = {1, 155, 4000, 200};  // [Alsweis] sec. 5.5
constexpr std::array<const char*, kinds> short_names = {"tree", "shrubs", "meadow", "flowers"};
/// Four stages are shown; at which steps is not printed.
constexpr std::array<int, 4> stages = {0, 8, 16, steps};

std::size_t by_tier(Tier tier, std::size_t smoke, std::size_t quick, std::size_t full) {
  return tier == Tier::full ? full : tier == Tier::quick ? quick : smoke;
}

/// What reaches the shrubs of the tree. Shrubs always harm each other, above and below.
struct Reach {
  const char* name;
  Influence above, below;
};

constexpr std::array reaches = {Reach{"roots-and-crown", Influence::harms, Influence::harms},
                                Reach{"roots-only", Influence::none, Influence::harms},
                                Reach{"crown-only", Influence::harms, Influence::none},
                                Reach{"neither", Influence::none, Influence::none}};

/// Tree and shrubs alone: meadow and flowers are ten times as small.
PopulationParameters tree_with_shrubs(const Reach& reach, std::uint64_t seed) {
  PopulationParameters parameters = plot_of(side, least_growth, seed);
  parameters.rule = "influence_signs";
  parameters.species = {species_of(tree, 0), species_of(shrub, counts[1])};
  parameters.competition.influence_above.assign(4, Influence::harms);
  parameters.competition.influence_below.assign(4, Influence::harms);
  constexpr std::size_t tree_on_shrub = 2;
  parameters.competition.influence_above[tree_on_shrub] = reach.above;
  parameters.competition.influence_below[tree_on_shrub] = reach.below;
  return parameters;
}

StartPlant tree_in_the_middle() {
  return in_the_middle_of(side, tree.start_radius);
}

/// The shrubs of one plot.
struct NearAndFar {
  Tally inside, outside;
};

NearAndFar near_and_far(const Reach& reach, std::uint64_t seed) {
  const StartPlant the_tree = tree_in_the_middle();
  Population population = population_of(tree_with_shrubs(reach, seed), {&the_tree, 1});
  Fates fates = fates_at_start(population.stand());
  for (int t = 0; t < steps; ++t) population.step();
  update_fates(population.stand(), fates);
  const double zone = zone_radius_of(tree.root_factor, fates.radius[0]);
  NearAndFar result;
  for (std::size_t k = 1; k < fates.size(); ++k) {
    const double distance = norm(fates.place[k] - the_tree.place);
    if (distance < zone) result.inside.add(fates, k);
    if (distance > zone + margin) result.outside.add(fates, k);
  }
  return result;
}

/// Plot by plot, where some shrubs stand near the tree; of what they have in the mean.
void record_plots(ExperimentContext& context, const std::string& group,
                  const std::vector<NearAndFar>& plots) {
  std::vector<double> far_survival, near_survival, far_radius, near_radius;
  for (const NearAndFar& plot : plots) {
    if (plot.inside.plants == 0) continue;
    far_survival.push_back(plot.outside.survival());
    near_survival.push_back(plot.inside.survival());
    if (plot.inside.survivors == 0) continue;
    far_radius.push_back(plot.outside.mean_radius());
    near_radius.push_back(plot.inside.mean_radius());
  }
  record_order(context, group + "/plots/survival_outside_over_inside", far_survival, near_survival);
  if (near_radius.size() > 1)
    record_order(context, group + "/plots/radius_outside_over_inside", far_radius, near_radius,
                 "m");
}

void record_near(ExperimentContext& context) {
  const std::size_t seeds = by_tier(context.tier(), 60, 200, 1000);
  for (const Reach& reach : reaches) {
    std::vector<NearAndFar> plots(seeds);
    for_runs(context, fmt::format("shrubs around a tree, {}", reach.name), seeds,
             [&](std::size_t run) {
               plots[run] = near_and_far(reach, seed_of_run(context, question_near_tree, run));
             });
    NearAndFar all;
    for (const NearAndFar& plot : plots) {
      all.inside += plot.inside;
      all.outside += plot.outside;
    }
    const std::string group = fmt::format("near/{}", reach.name);
    record_tally(context, group + "/inside", all.inside);
    record_tally(context, group + "/outside", all.outside);
    context.record(group + "/survival_standard_errors",
                   standard_errors_between(all.inside, all.outside), "standard errors");
    record_plots(context, group, plots);
  }
}

/// Mean loss of the shrubs that stand within the tree's roots now, from the tree alone; nothing if
/// there are none.
std::optional<double> loss_from_tree(const Population& population, const Reach& reach) {
  PopulationParameters alone = tree_with_shrubs(reach, 0);
  constexpr std::size_t shrub_on_shrub = 3;
  alone.competition.influence_above[shrub_on_shrub] = Influence::none;
  alone.competition.influence_below[shrub_on_shrub] = Influence::none;
  Population same(alone, population.state(), overlap_engine_named("layered_grid"));
  const std::vector<double> loss = same.losses();
  const Stand& stand = same.stand();
  const StartPlant the_tree = tree_in_the_middle();
  const double zone = same.root_radii()[order_of_ids(stand)[0]];
  RunningMoments inside;
  for (const std::size_t i : order_of_ids(stand))
    if (stand.id[i] != 0 && norm(stand.place(i) - the_tree.place) < zone) inside.add(loss[i]);
  if (inside.count() == 0) return std::nullopt;
  return inside.mean();
}

/// The start, and the last step before a shrub can die.
constexpr std::array<int, 2> early = {0, 4};

/// Loss from the tree in one plot, by moment.
struct PartsOfLoss {
  std::array<std::optional<double>, early.size()> by_roots, by_crown;
};

PartsOfLoss parts_of_loss(std::uint64_t seed) {
  const StartPlant the_tree = tree_in_the_middle();
  Population population = population_of(tree_with_shrubs(reaches[0], seed), {&the_tree, 1});
  PartsOfLoss parts;
  for (std::size_t m = 0; m < early.size(); ++m) {
    while (population.state().step < early[m]) population.step();
    parts.by_roots[m] = loss_from_tree(population, reaches[1]);
    parts.by_crown[m] = loss_from_tree(population, reaches[2]);
  }
  return parts;
}

/// How much of that is by roots and how much by the crown.
void record_parts_of_loss(ExperimentContext& context) {
  std::vector<PartsOfLoss> plots(by_tier(context.tier(), 60, 200, 1000));
  for_runs(context, "parts of loss", plots.size(), [&](std::size_t run) {
    plots[run] = parts_of_loss(seed_of_run(context, question_near_tree, run));
  });
  for (std::size_t m = 0; m < early.size(); ++m) {
    std::vector<double> by_roots, by_crown;
    for (const PartsOfLoss& parts : plots) {
      if (!parts.by_roots[m]) continue;
      by_roots.push_back(*parts.by_roots[m]);
      by_crown.push_back(*parts.by_crown[m]);
    }
    const std::string group = fmt::format("loss-from-tree/step-{}", early[m]);
    record_mean(context, group + "/by_roots", by_roots);
    record_mean(context, group + "/by_crown", by_crown);
    record_order(context, group + "/crown_over_roots", by_crown, by_roots);
  }
}

PopulationParameters whole_scene(std::uint64_t seed) {
  PopulationParameters parameters = plot_of(side, least_growth, seed);
  parameters.species = {species_of(tree, 0), species_of(shrub, counts[1]),
                        species_of(meadow_plant, counts[2]), species_of(flower, counts[3])};
  return parameters;
}

std::array<double, kinds> alive(const Stand& stand) {
  std::array<double, kinds> plants{};
  for (const SpeciesIndex species : stand.species) plants.at(species) += 1.0;
  return plants;
}

/// Of one plot, by stage, then by kind.
using Numbers = std::array<std::array<double, kinds>, stages.size()>;

Numbers numbers_of(std::uint64_t seed) {
  const StartPlant the_tree = tree_in_the_middle();
  Population population = population_of(whole_scene(seed), {&the_tree, 1});
  Numbers numbers{};
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    while (population.state().step < stages[stage]) population.step();
    numbers[stage] = alive(population.stand());
  }
  return numbers;
}

void record_decline(ExperimentContext& context) {
  std::vector<Numbers> plots(by_tier(context.tier(), 20, 20, 100));
  for_runs(context, "all 4356 plants", plots.size(), [&](std::size_t run) {
    plots[run] = numbers_of(seed_of_run(context, question_decline, run));
  });
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const std::string group = fmt::format("decline/{}", short_names[kind]);
    const auto plants = [&](std::size_t stage) {
      std::vector<double> values;
      for (const Numbers& numbers : plots) values.push_back(numbers[stage][kind]);
      return values;
    };
    for (std::size_t stage = 0; stage < stages.size(); ++stage)
      record_mean(context, fmt::format("{}/stage-{}", group, stage + 1), plants(stage), "plants");
    if (kind == 0) continue;
    record_order(context, group + "/third_over_last", plants(2), plants(3), "plants");
    record_order(context, group + "/first_over_last", plants(0), plants(3), "plants");
  }
}

/// Stems, with zones of tree and shrubs; those of meadow and flowers would hide each other.
StandPanel stage_panel(const Population& population) {
  StandPanel panel{.layers = {}, .caption = fmt::format("step {}", population.state().step)};
  for (const SpeciesIndex kind :
       {SpeciesIndex{2}, SpeciesIndex{3}, SpeciesIndex{1}, SpeciesIndex{0}}) {
    constexpr std::array<std::size_t, kinds> colours = {2, 0, 6, 7};
    std::vector<StandLayer> layers;
    if (kind < 2) {
      layers.push_back(root_zones_of(population, kind));
      layers.push_back(crown_zones_of(population, kind));
      layers[0].name = fmt::format("{}: crown (inner ring), roots (outer)",
                                   population.parameters().species[kind].name);
      layers[1].name = "";
    }
    layers.push_back(stems_of(population, kind));
    if (kind < 2) layers.back().name = "";
    for (StandLayer& layer : layers) {
      layer.colour = colours[kind];
      panel.layers.push_back(layer);
    }
  }
  return panel;
}

/// The middle of the plot, where the tree stands.
void draw_scene(ExperimentContext& context) {
  const StartPlant the_tree = tree_in_the_middle();
  Population population =
      population_of(whole_scene(seed_of_run(context, question_decline, 0)), {&the_tree, 1});
  std::vector<StandPanel> panels;
  for (const int stage : stages) {
    while (population.state().step < stage) population.step();
    panels.push_back(stage_panel(population));
  }
  const double half = 0.25 * side;
  const Rectangle view{the_tree.place - Point2{half, half}, the_tree.place + Point2{half, half}};
  context.artifact(
      "figure-5.7.svg",
      stand_panels_svg(
          {.ground = view, .columns = 4, .panel_width = 230.0}, panels,
          "Figure 5.7: four stages of a tree, 155 shrubs, 4000 meadow plants and 200 "
          "flowers; the middle 30 m of 60 m; inner rings are crowns, outer ones roots"));
}

void run(ExperimentContext& context) {
  record_near(context);
  record_parts_of_loss(context);
  record_decline(context);
  draw_scene(context);
}

}  // namespace

extern const ExperimentDescriptor tree_and_shrubs;
constinit const ExperimentDescriptor tree_and_shrubs{
    .id = "alsweis/tree-and-shrubs",
    .question = "Are shrubs sparser and slower near a tree, and is it by its roots or its crown?",
    .source = "[Alsweis] sec. 5.5, figure 5.7",
    .seconds = {1, 2, 6},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
