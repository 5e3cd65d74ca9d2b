// SPDX-License-Identifier: MIT
// How unequal plants become that start almost alike: the same hundred plants under each rule of
// competition, and under rules that the dissertation does not have.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/population/stand_statistics.hpp"
#include "core/statistics/gini.hpp"
#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t seeds = 20;
/// The step that claims are about; woody plants without competition are almost grown up then.
constexpr std::size_t main_step = 60;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct NamedRule {
  const char* name;
  const char* rule;
  double asymmetry_exponent = 1.0;
};

/// [Alsweis] (4.2) to (4.4), from no competition to the most unequal one.
constexpr std::array printed_rules = {
    NamedRule{"none", "none"}, NamedRule{"symmetric", "symmetric"}, NamedRule{"mixture", "mixture"},
    NamedRule{"asymmetric", "asymmetric"}};

/// One family that has both as its ends, pair by pair and with common ground divided once only,
/// and the model that the dissertation's is named after.
constexpr std::array other_rules = {NamedRule{"exponent-0", "asymmetry_exponent", 0.0},
                                    NamedRule{"exponent-0.5", "asymmetry_exponent", 0.5},
                                    NamedRule{"exponent-1", "asymmetry_exponent", 1.0},
                                    NamedRule{"exponent-2", "asymmetry_exponent", 2.0},
                                    NamedRule{"exponent-8", "asymmetry_exponent", 8.0},
                                    NamedRule{"exponent-inf", "asymmetry_exponent", infinity},
                                    NamedRule{"exact-0", "exact_shares", 0.0},
                                    NamedRule{"exact-1", "exact_shares", 1.0},
                                    NamedRule{"exact-inf", "exact_shares", infinity},
                                    NamedRule{"field", "field_of_neighbourhood"}};

PopulationParameters hundred_plants(const NamedRule& rule, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = rule.rule;
  parameters.competition.asymmetry_exponent = rule.asymmetry_exponent;
  parameters.species = {{.name = "woody plant", .count = 100}};
  return parameters;
}

std::vector<double> basal_areas(const Stand& stand) {
  std::vector<double> areas;
  for (const double radius : stand.stem_radius) areas.push_back(radius * radius);  // times pi
  return areas;
}

/// One entry per step, 0 and the last included, with one value per seed.
struct Course {
  std::vector<std::vector<double>> gini, mean_radius;
  std::vector<double> last_areas = {};  ///< of all plants of all seeds after main_step

  explicit Course(std::size_t steps)
      : gini(steps + 1, std::vector<double>(seeds)), mean_radius(gini) {}
};

Course course_of(ExperimentContext& context, const NamedRule& rule, std::size_t steps) {
  Course course(steps);
  std::array<std::vector<double>, seeds> areas;
  for_runs(context, rule.name, seeds, [&](std::size_t s) {
    Population population =
        population_of(hundred_plants(rule, seed_of_run(context, Question::size_inequality, s)));
    for (std::size_t t = 0;; ++t) {
      const PlantStatistics now =
          stand_statistics(population.stand(), std::vector<double>(population.stand().size()), 1,
                           population.parameters().ground.area())
              .all;
      course.gini[t][s] = now.gini;
      course.mean_radius[t][s] = now.mean_radius;
      if (t == main_step) areas[s] = basal_areas(population.stand());
      if (t == steps) break;
      population.step();
    }
  });
  for (const auto& some : areas)
    course.last_areas.insert(course.last_areas.end(), some.begin(), some.end());
  return course;
}

void record_course(ExperimentContext& context, const NamedRule& rule, const Course& course,
                   std::size_t step) {
  const std::string group = fmt::format("{}/step-{}", rule.name, step);
  record_mean(context, group + "/gini", course.gini[step]);
  record_mean(context, group + "/mean_radius", course.mean_radius[step], "m");
}

/// Each rule beside the one before it, from the same plants.
template <std::size_t Count>
void record_orders(ExperimentContext& context, const std::array<NamedRule, Count>& rules,
                   const std::vector<Course>& courses, std::size_t first, std::size_t last,
                   std::size_t step) {
  for (std::size_t k = first + 1; k <= last; ++k) {
    const Course &low = courses[k - 1], &high = courses[k];
    const std::string group =
        fmt::format("step-{}/{}-over-{}", step, rules[k].name, rules[k - 1].name);
    record_paired(context, group + "/gini", high.gini[step], low.gini[step]);
    record_paired(context, group + "/smallness", low.mean_radius[step], high.mean_radius[step],
                  "m");
  }
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void draw_figure(ExperimentContext& context, const std::vector<Course>& courses) {
  PlotPanel over_time{
      .caption = "over time", .x_label = "steps", .y_label = "Gini coefficient of basal area"};
  PlotPanel shares{.caption = fmt::format("after {} steps", main_step),
                   .x_label = "share of plants, the smallest first",
                   .y_label = "share of basal area",
                   .x_range = AxisRange{0.0, 1.0},
                   .y_range = AxisRange{0.0, 1.0}};
  for (std::size_t k = 0; k < printed_rules.size(); ++k) {
    PlotCurve gini{.name = printed_rules[k].name}, lorenz{.name = printed_rules[k].name};
    for (std::size_t t = 0; t < courses[k].gini.size(); ++t) {
      gini.x.push_back(static_cast<double>(t));
      gini.y.push_back(mean_of(courses[k].gini[t]));
    }
    for (const LorenzPoint& point : lorenz_curve(courses[k].last_areas)) {
      lorenz.x.push_back(point.share_of_number);
      lorenz.y.push_back(point.share_of_sum);
    }
    over_time.curves.push_back(gini);
    shares.curves.push_back(lorenz);
  }
  add_plot(context, "size-inequality",
           {.title = "Inequality of 100 plants without and with competition",
            .description = "Gini coefficient of basal area over the steps, mean of 20 runs, and "
                           "Lorenz curves of the last areas: the farther below the diagonal, the "
                           "less equal.",
            .panels = {over_time, shares}});
}

void record_printed_rules(ExperimentContext& context) {
  const bool is_smoke = context.tier() == Tier::smoke;
  const std::size_t steps = is_smoke ? main_step : 160;
  std::vector<Course> courses;
  for (const NamedRule& rule : printed_rules) courses.push_back(course_of(context, rule, steps));
  for (std::size_t step = 20; step <= steps; step += 20) {
    for (std::size_t k = 0; k < courses.size(); ++k)
      record_course(context, printed_rules[k], courses[k], step);
    record_orders(context, printed_rules, courses, 0, courses.size() - 1, step);
    // What the mixture stands between.
    record_paired(context, fmt::format("step-{}/asymmetric-over-symmetric/gini", step),
                  courses[3].gini[step], courses[1].gini[step]);
  }
  draw_figure(context, courses);
}

/// Ours, without claims.
void record_other_rules(ExperimentContext& context) {
  std::vector<Course> courses;
  for (const NamedRule& rule : other_rules) {
    courses.push_back(course_of(context, rule, main_step));
    record_course(context, rule, courses.back(), main_step);
  }
  record_orders(context, other_rules, courses, 0, 5, main_step);
  record_orders(context, other_rules, courses, 6, 8, main_step);
}

/// Two plants 8 m apart on open ground, as in [Alsweis] fig. 4.3.
std::vector<std::vector<double>> radii_of_two(const char* rule, double first, double second) {
  PopulationParameters parameters;
  parameters.rule = rule;
  parameters.ground = {{0.0, 0.0}, {48.0, 40.0}};
  parameters.is_torus = false;
  parameters.species = {{.name = "plant"}};
  const std::array plants = {StartPlant{{20.0, 20.0}, first}, StartPlant{{28.0, 20.0}, second}};
  Population population = population_of(parameters, plants);
  std::vector<std::vector<double>> radii(2);
  for (std::size_t t = 0; t <= main_step; ++t) {
    for (const auto& [id, radius] : by_plant(population.stand(), population.stand().stem_radius))
      radii[id].push_back(radius);
    population.step();
  }
  return radii;
}

PlotPanel panel_of_two(const char* rule) {
  const auto alone = radii_of_two("none", 0.06, 0.03), two = radii_of_two(rule, 0.06, 0.03);
  PlotPanel panel{.caption = rule,
                  .x_label = "steps",
                  .y_label = "stem radius, m",
                  .y_range = AxisRange{0.0, 0.5}};
  std::vector<double> steps;
  for (std::size_t t = 0; t <= main_step; ++t) steps.push_back(static_cast<double>(t));
  const auto add = [&](const char* name, const std::vector<double>& y, PlotStyle style,
                       std::size_t colour) {
    panel.curves.push_back({.name = name, .x = steps, .y = y, .style = style, .colour = colour});
  };
  add("larger plant", two[0], PlotStyle::solid, 0);
  add("smaller plant", two[1], PlotStyle::solid, 1);
  add("larger plant, alone", alone[0], PlotStyle::dashed, 0);
  add("smaller plant, alone", alone[1], PlotStyle::dashed, 1);
  return panel;
}

void draw_two_plants(ExperimentContext& context) {
  add_plot(context, "figure-4.3",
           {.title = "Figure 4.3: two plants 8 m apart, and the same plants alone",
            .description = "Stem radius over the steps. Under symmetric competition both plants "
                           "stay behind those alone; under asymmetric competition only the smaller "
                           "one does.",
            .panels = {panel_of_two("symmetric"), panel_of_two("asymmetric")}});
}

void run(ExperimentContext& context) {
  record_printed_rules(context);
  record_other_rules(context);
  draw_two_plants(context);
}

}  // namespace

extern const ExperimentDescriptor size_inequality;
constinit const ExperimentDescriptor size_inequality{
    .id = "alsweis/size-inequality",
    .question = "Does competition make plants unequal, the more so the more the larger one wins?",
    .source = "[Alsweis] sec. 4.2, 4.8",
    .seconds = {2, 3, 3},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
