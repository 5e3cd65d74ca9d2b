// SPDX-License-Identifier: MIT
// Plants on ground that is rich in one place and poor in another, where zones of influence have to
// be larger: how far they reach, and how many survive.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/population/stand_picture.hpp"
#include "core/population/stand_statistics.hpp"
#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t steps = 120;
constexpr double side = 200.0;

/// Strips of equal width from west to east, with their zone factors d of (4.1).
using Strips = std::vector<double>;
const Strips halves = {8.0, 15.0};
/// In the order of [Alsweis] fig. 4.6, from most nutrients to least; it has no region V. Where the
/// regions lie is not published: strips are ours.
const Strips five_regions = {6.0, 8.0, 10.0, 12.5, 15.0};
constexpr std::array region_names = {"I", "III", "II", "IV", "VI"};

PopulationParameters plants_on(const Strips& factors, const char* rule, std::int64_t count,
                               std::uint64_t seed) {
  const auto [rich, poor] = std::minmax_element(factors.begin(), factors.end());
  std::vector<double> nutrients;
  for (const double d : factors) nutrients.push_back((*poor - d) / (*poor - *rich));
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = rule;
  parameters.ground = {{0.0, 0.0}, {side, side}};
  parameters.species = {{.name = "woody plant",
                         .count = count,
                         .roots = {.poor_factor = *poor, .rich_factor = *rich}}};
  parameters.mortality = {.rule = MortalityRule::mean_growth, .threshold = 0.0002};
  parameters.nutrients =
      ResourceMap(static_cast<int>(factors.size()), 1, nutrients, parameters.ground);
  return parameters;
}

struct StripState {
  std::vector<double> plants, mean_zone;  ///< by strip; zones in m
};

StripState state_of(const Population& population, std::size_t strips) {
  StripState state{std::vector<double>(strips), std::vector<double>(strips)};
  const std::vector<double> zones = population.root_radii();
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const auto strip =
        static_cast<std::size_t>(population.stand().x[i] / side * static_cast<double>(strips));
    state.plants[std::min(strip, strips - 1)] += 1.0;
    state.mean_zone[std::min(strip, strips - 1)] += zones[i];
  }
  for (std::size_t k = 0; k < strips; ++k) state.mean_zone[k] /= state.plants[k];
  return state;
}

/// One entry per step, 0 and the last included.
std::vector<StripState> course_of(const PopulationParameters& parameters, std::size_t strips) {
  Population population = population_of(parameters);
  std::vector<StripState> course = {state_of(population, strips)};
  for (std::size_t t = 0; t < steps; ++t) {
    population.step();
    course.push_back(state_of(population, strips));
  }
  return course;
}

/// By run; the same plants for every rule.
using Courses = std::vector<std::vector<StripState>>;

Courses courses_of(ExperimentContext& context, Question question, const Strips& factors,
                   const char* rule, std::int64_t count, std::size_t runs) {
  Courses courses(runs);
  for_runs(context, fmt::format("{} strips, {}", factors.size(), rule), runs, [&](std::size_t s) {
    courses[s] = course_of(plants_on(factors, rule, count, seed_of_run(context, question, s)),
                           factors.size());
  });
  return courses;
}

/// Rich ground in the west, poor ground in the east: survivors and zones of both.
void record_halves(ExperimentContext& context) {
  for (const char* rule : {"symmetric", "mixture", "asymmetric"}) {
    const auto courses = courses_of(context, Question::halves, halves, rule, 400, 20);
    const std::string group = fmt::format("halves/{}", rule);
    std::vector<double> ratio, rich, poor;
    for (const auto& course : courses) {
      rich.push_back(course[steps].plants[0]);
      poor.push_back(course[steps].plants[1]);
      ratio.push_back(poor.back() / rich.back());
    }
    record_mean(context, group + "/poor_over_rich", ratio);
    context.record(group + "/largest_poor_over_rich",
                   *std::max_element(ratio.begin(), ratio.end()));
    record_paired(context, group + "/rich_over_poor", rich, poor, "plants");
    for (const std::size_t step : {0u, 20u, 60u, 120u}) {
      std::vector<double> zones;
      for (const auto& course : courses)
        zones.push_back(course[step].mean_zone[1] / course[step].mean_zone[0]);
      record_mean(context, fmt::format("{}/zones_poor_over_rich/step-{}", group, step), zones);
    }
  }
}

/// Figure 4.8 in numbers: plants of each region over time.
void draw_bands(ExperimentContext& context, const Courses& courses) {
  const std::size_t count = five_regions.size();
  const double hectares = side * side / 10'000.0 / static_cast<double>(count);
  PlotPanel panel{.caption = "500 plants, mixed competition",
                  .x_label = "steps",
                  .y_label = "plants per hectare",
                  .y_range = AxisRange{0.0, 140.0}};
  for (std::size_t k = 0; k < count; ++k) {
    PlotCurve curve{.name = fmt::format("region {}", region_names[k])};
    for (std::size_t t = 0; t <= steps; ++t) {
      double plants = 0.0;
      for (const auto& course : courses) plants += course[t].plants[k];
      curve.x.push_back(static_cast<double>(t));
      curve.y.push_back(plants / static_cast<double>(courses.size()) / hectares);
    }
    panel.curves.push_back(curve);
  }
  add_plot(context, "figure-4.8",
           {.title = "Figure 4.8 in numbers: plants on five regions",
            .description = "Plants per hectare over the steps on five strips of ours, from most "
                           "nutrients (I) to least (VI); mean of all runs.",
            .panels = {panel}});
}

/// Which part of its plants each region keeps, and how often a poorer one keeps less.
void record_bands(ExperimentContext& context) {
  const auto courses = courses_of(context, Question::bands, five_regions, "mixture", 500, 40);
  const std::size_t count = five_regions.size();
  std::vector<std::vector<double>> survival(count);
  std::int64_t ordered = 0;
  for (const auto& course : courses) {
    bool falls = true;
    for (std::size_t k = 0; k < count; ++k) {
      survival[k].push_back(course[steps].plants[k] / course[0].plants[k]);
      falls = falls && (k == 0 || survival[k].back() < survival[k - 1].back());
    }
    ordered += falls ? 1 : 0;
  }
  for (std::size_t k = 0; k < count; ++k)
    record_mean(context, fmt::format("bands/survival/region-{}", k + 1), survival[k]);
  for (std::size_t k = 1; k < count; ++k)
    record_paired(context, fmt::format("bands/region-{}-over-{}", k, k + 1), survival[k - 1],
                  survival[k]);
  record_paired(context, "bands/richest-over-poorest", survival[0], survival[count - 1]);
  context.record("bands/all_ordered", ordered, "runs");

  draw_bands(context, courses);
}

/// 100 plants of one kind on 200 m by 200 m, as they are spread.
void record_first_test(ExperimentContext& context) {
  constexpr std::size_t starts = 1000;
  std::vector<double> density(starts), torus(starts), bordered(starts);
  for_runs(context, "first test", starts, [&](std::size_t s) {
    PopulationParameters parameters;
    parameters.seed = seed_of_run(context, Question::first_test, s);
    parameters.ground = {{0.0, 0.0}, {side, side}};
    parameters.species = {{.name = "plant", .count = 100}};
    const Stand stand = sow(parameters).stand;
    density[s] = static_cast<double>(stand.size()) / parameters.ground.area();
    torus[s] = stand_pattern(stand, parameters.ground, true).mean_nearest_distance;
    bordered[s] = stand_pattern(stand, parameters.ground, false).mean_nearest_distance;
  });
  record_mean(context, "first-test/density", density, "1/m2");
  record_mean(context, "first-test/torus/nearest_distance", torus, "m");
  record_mean(context, "first-test/border/nearest_distance", bordered, "m");
}

/// 100 plants that bear seeds, on the five strips, at three moments.
void draw_stands(ExperimentContext& context) {
  PopulationParameters parameters =
      plants_on(five_regions, "asymmetric", 100, seed_of_run(context, Question::figures, 0));
  parameters.species[0].reproduction = {.threshold = 0.25,
                                        .seeds_per_metre = 20.0,
                                        .dispersal_distance = 10.0,
                                        .establishment = 0.03,
                                        .seedling_radius = 0.03};
  Population population = population_of(parameters);
  const auto draw = [&](const std::string& name, const std::string& title) {
    const std::vector<double> loss = population.losses(), zones = population.root_radii();
    context.artifact(name, stand_svg({.parameters = population.parameters(),
                                      .stand = population.stand(),
                                      .loss = loss,
                                      .root_radius = zones,
                                      .crown_radius = {}},
                                     title));
  };
  draw("figure-4.6.svg",
       "Five strips of ours in the order of figure 4.6: I, richest, on the left, to VI, poorest");
  for (const int moment : {40, 80}) {
    while (population.state().step < moment) population.step();
    draw(fmt::format("figure-4.7-step-{}.svg", moment),
         fmt::format("Figure 4.7 on five strips of ours: asymmetric competition, step {}", moment));
  }
}

void run(ExperimentContext& context) {
  record_first_test(context);
  record_halves(context);
  record_bands(context);
  draw_stands(context);
}

}  // namespace

extern const ExperimentDescriptor nutrient_regions;
constinit const ExperimentDescriptor nutrient_regions{
    .id = "alsweis/nutrient-regions",
    .question = "Do fewer plants survive where nutrients are scarce and zones therefore larger?",
    .source = "[Alsweis] sec. 4.7, figures 4.6 to 4.8",
    .seconds = {2, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
