// SPDX-License-Identifier: MIT
// Figures 7.5 and 7.9: seedlings around nurse plants. Whether there are more of them near nurses,
// and whether there are none elsewhere: by (7.6) as printed, and with a stress of open ground that
// it lacks.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/plant_fates.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 60.0, least_growth = 0.01;
constexpr int steps = 40;
/// Nurses are grown up and reach 4 m far.
constexpr PlantKind nurse_plant{"nurse plant", 4, 4, 1.0, 0.01, 1.0};
constexpr PlantKind seedling{"seedling", 5, 4, 0.05, 0.01, 0.004};
constexpr std::int64_t nurse_count = 10, seedling_count = 600;
constexpr double near = 4.0, far = 5.0;  ///< m

/// A nurse's crown and roots on a seedling, and what a seedling suffers anywhere.
struct Variant {
  const char* name;
  double above_share;
  Influence crown, roots;
  double stress = 0.0;
  /// Taken together for one pair of numbers: a single plot has some 70 seedlings near nurses, too
  /// few to tell 88 from 81 percent every time.
  std::size_t plots = 1;
};

/// (7.6), with the stress that sec. 7.4 speaks of, without nurses' influence, and with shade that
/// helps, as sec. 7.4 has it. Roots help more than shade harms for shares below 1/3 only, and the
/// other way round.
constexpr std::array variants = {
    Variant{"printed", 0.25, Influence::harms, Influence::helps, 0.0, 4},
    Variant{"no-influence", 0.25, Influence::none, Influence::none, 0.0, 4},
    Variant{"half-light", 0.5, Influence::harms, Influence::helps, 0.0, 4},
    Variant{"stress-0.45", 0.25, Influence::harms, Influence::helps, 0.45},
    Variant{"stress-0.5", 0.25, Influence::harms, Influence::helps, 0.5},
    Variant{"stress-0.6", 0.25, Influence::harms, Influence::helps, 0.6},
    Variant{"stress-0.6-no-influence", 0.25, Influence::none, Influence::none, 0.6},
    Variant{"stress-0.6-shade-helps", 0.75, Influence::helps, Influence::harms, 0.6}};

const Variant& variant_named(const std::string& name) {
  return *std::find_if(variants.begin(), variants.end(),
                       [&](const Variant& variant) { return variant.name == name; });
}

PopulationParameters scene(const Variant& variant, std::uint64_t seed) {
  PopulationParameters parameters = plot_of(side, least_growth, seed);
  parameters.rule = "nurse";
  parameters.species = {species_of(nurse_plant, nurse_count), species_of(seedling, seedling_count)};
  Species& nurses = parameters.species[0];
  nurses.start_radius_low = nurses.start_radius_high = nurse_plant.start_radius;
  parameters.species[1].traits.open_ground_stress = variant.stress;
  CompetitionParameters& competition = parameters.competition;
  competition.above_share = variant.above_share;
  // Nobody does anything to nurses; seedlings harm each other.
  competition.influence_above = {Influence::none, Influence::none, variant.crown, Influence::harms};
  competition.influence_below = {Influence::none, Influence::none, variant.roots, Influence::harms};
  return parameters;
}

struct NearAndFar {
  Tally inside, outside;

  NearAndFar& operator+=(const NearAndFar& other) {
    inside += other.inside;
    outside += other.outside;
    return *this;
  }
};

double distance_to_nurse(const Fates& fates, const Point2& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < fates.size(); ++k)
    if (fates.species[k] == 0) nearest = std::min(nearest, norm(fates.place[k] - place));
  return nearest;
}

NearAndFar near_and_far(const Variant& variant, std::uint64_t seed) {
  Population population = population_of(scene(variant, seed));
  Fates fates = fates_at_start(population.stand());
  for (int t = 0; t < steps; ++t) population.step();
  update_fates(population.stand(), fates);
  NearAndFar result;
  for (std::size_t k = 0; k < fates.size(); ++k) {
    if (fates.species[k] == 0) continue;
    const double distance = distance_to_nurse(fates, fates.place[k]);
    if (distance < near) result.inside.add(fates, k);
    if (distance > far) result.outside.add(fates, k);
  }
  return result;
}

void record_variant(ExperimentContext& context, const Variant& variant) {
  const std::size_t seeds = context.tier() == Tier::full ? 100 : 20;
  std::vector<NearAndFar> pairs(seeds);
  for_runs(context, variant.name, seeds, [&](std::size_t run) {
    for (std::size_t plot = run * variant.plots; plot < (run + 1) * variant.plots; ++plot)
      pairs[run] += near_and_far(variant, seed_of_run(context, question_nurses, plot));
  });
  NearAndFar all;
  std::vector<double> inside, outside;
  for (const NearAndFar& pair : pairs) {
    all += pair;
    inside.push_back(pair.inside.survival());
    outside.push_back(pair.outside.survival());
  }
  const std::string group = variant.name;
  record_tally(context, group + "/inside", all.inside);
  record_tally(context, group + "/outside", all.outside);
  record_mean(context, group + "/survival_inside", inside);
  record_mean(context, group + "/survival_outside", outside);
  record_order(context, group + "/survival_inside_over_outside", inside, outside);
  context.record(group + "/largest_survival_outside",
                 *std::max_element(outside.begin(), outside.end()));
}

/// Nurses' zones, and seedlings as large as their crowns.
StandPanel panel_of(const Population& population, const std::string& caption) {
  StandPanel panel{.layers = {crown_zones_of(population, 1), crown_zones_of(population, 0),
                              stems_of(population, 0, 0.5)},
                   .caption = caption};
  panel.layers[0].mark = StandMark::disc;
  panel.layers[0].name = "crown of a seedling";
  panel.layers[1].name = "crown of a nurse plant";
  panel.layers[2].name = "";
  constexpr std::array<std::size_t, 3> colours = {6, 2, 2};
  for (std::size_t k = 0; k < colours.size(); ++k) panel.layers[k].colour = colours[k];
  return panel;
}

StandMap map_of_plot() {
  return {.ground = {{0.0, 0.0}, {side, side}}, .columns = 4, .panel_width = 230.0};
}

/// Four stages where open ground is too hard for seedlings.
void draw_stages(ExperimentContext& context) {
  Population population =
      population_of(scene(variant_named("stress-0.6"), seed_of_run(context, question_nurses, 0)));
  std::vector<StandPanel> panels;
  for (const int stage : {0, 6, 20, steps}) {
    while (population.state().step < stage) population.step();
    panels.push_back(panel_of(population, fmt::format("step {}", stage)));
  }
  context.artifact("figure-7.5.svg",
                   stand_panels_svg(map_of_plot(), panels,
                                    "Figure 7.5: four stages of seedlings around nurse plants, "
                                    "with a stress of 0.6 on open ground"));
}

/// What is left by (7.6) as printed, and with more and more stress.
void draw_ends(ExperimentContext& context) {
  std::vector<StandPanel> panels;
  for (const char* name : {"printed", "stress-0.45", "stress-0.6", "stress-0.6-shade-helps"}) {
    Population population =
        population_of(scene(variant_named(name), seed_of_run(context, question_nurses, 0)));
    for (int t = 0; t < steps; ++t) population.step();
    panels.push_back(panel_of(population, name));
  }
  panels[0].caption = "(7.6) as printed";
  panels[1].caption = "stress 0.45";
  panels[2].caption = "stress 0.6";
  panels[3].caption = "stress 0.6, but shade helps";
  context.artifact("figure-7.9.svg",
                   stand_panels_svg(map_of_plot(), panels,
                                    "Figure 7.9: seedlings around nurse plants after 40 steps"));
}

void run(ExperimentContext& context) {
  for (const Variant& variant : variants) record_variant(context, variant);
  draw_stages(context);
  draw_ends(context);
}

}  // namespace

extern const ExperimentDescriptor nurse_plants;
constinit const ExperimentDescriptor nurse_plants{
    .id = "alsweis/nurse-plants",
    .question = "Do small plants grow better near nurse plants, and nowhere else?",
    .source = "[Alsweis] sec. 7.4, 7.6, figures 7.5 and 7.9",
    .seconds = {1, 1, 5},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
