// SPDX-License-Identifier: MIT
// Stands that thin themselves out: who starts denser loses more, and mean mass rises along a
// straight line on logarithmic scales while plants die.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/statistics/bootstrap.hpp"
#include "core/statistics/reduced_major_axis.hpp"
#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t seeds = 20;

PopulationParameters stand_of(std::int64_t count, const char* rule, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = rule;
  parameters.species = {
      {.name = "woody plant", .count = count, .roots = {.poor_factor = 12.0, .rich_factor = 12.0}}};
  parameters.mortality = {.rule = MortalityRule::mean_growth, .threshold = 0.0002};
  return parameters;
}

/// Which part of its plants a stand of 4 ha keeps for 100 steps, from five densities. Sown from one
/// stream: the plants of a thin stand are among those of the denser ones.
void record_density(ExperimentContext& context, const char* rule) {
  std::vector<double> thinner;
  for (const std::int64_t count : {50, 100, 200, 400, 800}) {
    std::vector<double> survival(seeds);
    for_runs(context, fmt::format("{} plants, {}", count, rule), seeds, [&](std::size_t s) {
      const Population end =
          lived(stand_of(count, rule, seed_of_run(context, Question::density, s)), 100);
      survival[s] = static_cast<double>(end.stand().size()) / static_cast<double>(count);
    });
    const std::string group = fmt::format("density/{}", rule);
    record_mean(context, fmt::format("{}/plants-{}/survival", group, count), survival);
    if (!thinner.empty())
      record_paired(context, fmt::format("{}/{}-over-{}", group, count / 2, count), thinner,
                    survival);
    thinner = survival;
  }
}

/// A zone law d R^b with the size of plants that brings zones of some 6 m to a stand of 60 m.
struct ThinningSpecies {
  const char* name;
  double exponent, factor, largest_radius;
};
constexpr std::array thinning_species = {
    ThinningSpecies{"zone-1", 1.0, 20.0, 2.0}, ThinningSpecies{"zone-0.75", 0.75, 10.0, 3.0},
    ThinningSpecies{"zone-0.67", 2.0 / 3.0, 10.0, 3.0}, ThinningSpecies{"zone-0.5", 0.5, 8.0, 3.0}};

struct MassLaw {
  const char* name;
  double exponent;  ///< of the stem radius
};
constexpr std::array mass_laws = {MassLaw{"mass-2", 2.0}, MassLaw{"mass-2.67", 8.0 / 3.0},
                                  MassLaw{"mass-3", 3.0}};
constexpr std::size_t cubic = 2;

constexpr double side = 60.0;
constexpr std::int64_t sown = 800;
/// The part of a run to which a line is fitted, in survivors.
constexpr double from_survivors = 0.7, to_survivors = 0.04;

PopulationParameters thinning_stand(const ThinningSpecies& species, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = "asymmetric";
  parameters.ground = {{0.0, 0.0}, {side, side}};
  parameters.species = {{.name = "plant",
                         .count = sown,
                         .start_radius_low = 0.9 * 0.04 * species.largest_radius,
                         .start_radius_high = 1.1 * 0.04 * species.largest_radius,
                         .largest_radius = species.largest_radius,
                         .growth_rate = 0.1 * species.largest_radius,
                         .roots = {.poor_factor = species.factor,
                                   .rich_factor = species.factor,
                                   .exponent = species.exponent}}};
  parameters.mortality = {.rule = MortalityRule::mean_relative_growth,
                          .threshold = 0.01,
                          .grown_up = 1.0};  // nobody is spared: none gets there
  return parameters;
}

/// Decimal logarithms, step by step while the stand is thinning.
struct Course {
  std::vector<double> density;                                     ///< plants per m^2
  std::array<std::vector<double>, mass_laws.size()> mass, in_all;  ///< per plant; per m^2
  std::vector<double> cover;  ///< zones over ground, itself no logarithm
};

double mean_power(const std::vector<double>& radii, double exponent) {
  double sum = 0.0;
  for (const double radius : radii) sum += std::pow(radius, exponent);
  return sum / static_cast<double>(radii.size());
}

void add_point(const Population& population, const ThinningSpecies& species, Course& course) {
  const std::vector<double>& radii = population.stand().stem_radius;
  const double density = static_cast<double>(radii.size()) / (side * side);
  course.density.push_back(std::log10(density));
  for (std::size_t k = 0; k < mass_laws.size(); ++k) {
    course.mass[k].push_back(std::log10(mean_power(radii, mass_laws[k].exponent)));
    course.in_all[k].push_back(course.mass[k].back() + course.density.back());
  }
  course.cover.push_back(std::numbers::pi * species.factor * species.factor *
                         mean_power(radii, 2.0 * species.exponent) * density);
}

Course course_of(const ThinningSpecies& species, std::uint64_t seed) {
  Population population = population_of(thinning_stand(species, seed));
  Course course;
  for (int t = 0; t < 120; ++t) {
    population.step();
    const double survivors =
        static_cast<double>(population.stand().size()) / static_cast<double>(sown);
    if (survivors < to_survivors) break;
    if (survivors <= from_survivors) add_point(population, species, course);
  }
  return course;
}

struct Lines {
  std::vector<double> slope, r_squared, yield_slope;
};

Lines lines_of(const std::vector<Course>& courses, std::size_t mass) {
  Lines lines;
  for (const Course& course : courses) {
    const auto line = reduced_major_axis(course.density, course.mass[mass]).value();
    lines.slope.push_back(line.slope);
    lines.r_squared.push_back(line.r_squared);
    lines.yield_slope.push_back(
        least_squares_line(course.density, course.in_all[mass]).value().slope);
  }
  return lines;
}

/// Runs are the blocks of the bootstrap: points of one run follow from each other.
void record_slopes(ExperimentContext& context, const std::string& group, const Lines& lines) {
  const Estimate slope = median_estimate(lines.slope);
  record_mean(context, group + "/slope", lines.slope);
  context.record(group + "/median_slope", slope.value);
  context.record(group + "/median_slope_low", slope.low);
  context.record(group + "/median_slope_high", slope.high);
  context.record(group + "/steepest", *std::min_element(lines.slope.begin(), lines.slope.end()));
  context.record(group + "/flattest", *std::max_element(lines.slope.begin(), lines.slope.end()));
  record_mean(context, group + "/r_squared", lines.r_squared);
  context.record(group + "/least_r_squared",
                 *std::min_element(lines.r_squared.begin(), lines.r_squared.end()));
  record_mean(context, group + "/yield_slope", lines.yield_slope);
}

void record_cover(ExperimentContext& context, const std::string& group,
                  const std::vector<Course>& courses) {
  std::vector<double> first, last;
  for (const Course& course : courses) {
    first.push_back(course.cover.front());
    last.push_back(course.cover.back());
  }
  record_mean(context, group + "/cover/first", first);
  record_mean(context, group + "/cover/last", last);
}

PlotPanel thinning_panel(const std::string& caption) {
  return {.caption = caption,
          .x_label = "plants per m²",
          .y_label = "mean R³, m³",
          .log_x = true,
          .log_y = true};
}

PlotCurve curve_of(const std::string& name, const Course& course) {
  PlotCurve curve{.name = name};
  for (std::size_t i = 0; i < course.density.size(); ++i) {
    curve.x.push_back(std::pow(10.0, course.density[i]));
    curve.y.push_back(std::pow(10.0, course.mass[cubic][i]));
  }
  return curve;
}

/// A line of this slope through the middle of a course.
PlotCurve slope_through(const std::string& name, const Course& course, double slope) {
  const PlotCurve points = curve_of(name, course);
  const std::size_t middle = points.x.size() / 2;
  PlotCurve line{.name = name, .style = PlotStyle::dashed};
  for (const double x : {points.x.front(), points.x.back()}) {
    line.x.push_back(x);
    line.y.push_back(points.y[middle] * std::pow(x / points.x[middle], slope));
  }
  return line;
}

std::vector<Course> courses_of(ExperimentContext& context, const ThinningSpecies& species) {
  std::vector<Course> courses(seeds);
  for_runs(context, species.name, seeds, [&](std::size_t s) {
    courses[s] = course_of(species, seed_of_run(context, Question::thinning, s));
  });
  return courses;
}

/// Each zone law after the one before it, whose line must be flatter.
void record_thinning(ExperimentContext& context, const std::vector<std::vector<Course>>& all) {
  std::vector<double> flatter;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::string group = fmt::format("thinning/{}", thinning_species[n].name);
    for (std::size_t k = 0; k < mass_laws.size(); ++k)
      record_slopes(context, fmt::format("{}/{}", group, mass_laws[k].name), lines_of(all[n], k));
    record_cover(context, group, all[n]);
    const std::vector<double> slope = lines_of(all[n], cubic).slope;
    if (!flatter.empty()) record_paired(context, group + "/steeper", flatter, slope);
    flatter = slope;
  }
}

void draw_thinning(ExperimentContext& context, const std::vector<std::vector<Course>>& all) {
  PlotPanel one = thinning_panel("zones 20 R, six runs"), each = thinning_panel("zones d R^b");
  for (std::size_t s = 0; s < 6; ++s)
    one.curves.push_back(curve_of(fmt::format("run {}", s + 1), all[0][s]));
  one.curves.push_back(slope_through("slope -3/2", all[0][0], -1.5));
  for (std::size_t n = 0; n < all.size(); ++n)
    each.curves.push_back(
        curve_of(fmt::format("b = {:.3g}", thinning_species[n].exponent), all[n][0]));
  add_plot(context, "figure-2.6",
           {.title = "Figure 2.6: mass against density of thinning stands",
            .description = "Mean cubed stem radius over plants per area, both axes logarithmic; "
                           "stands move from right to left. Left six runs beside a line of slope "
                           "-3/2, right one run for each law of the zones.",
            .panels = {one, each}});
}

void run(ExperimentContext& context) {
  for (const char* rule : {"symmetric", "mixture", "asymmetric"}) record_density(context, rule);
  std::vector<std::vector<Course>> all;
  for (const ThinningSpecies& species : thinning_species)
    all.push_back(courses_of(context, species));
  record_thinning(context, all);
  draw_thinning(context, all);
}

}  // namespace

extern const ExperimentDescriptor self_thinning;
constinit const ExperimentDescriptor self_thinning{
    .id = "alsweis/self-thinning",
    .question = "Do dense stands lose more plants, and does mass follow the -3/2 law meanwhile?",
    .source = "[Alsweis] sec. 2.5, eq. 2.15-2.17, figure 2.6",
    .seconds = {2, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
