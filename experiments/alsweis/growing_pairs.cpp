// SPDX-License-Identifier: MIT
// Two neighbours that grow: who wins by size, by roots, or because the other falls ill.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_competition_zones.hpp"
#include "reference/oracles/alsweis_stand.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace print = phytobench::oracles::alsweis::competition;

constexpr int steps = 80;
constexpr double distance = 8.0, start_radius = 0.05;

/// Stem radii after every step, the start first.
using Sizes = std::vector<double>;
using Pair = std::array<Sizes, 2>;

/// Two woody species that differ in nothing yet, on open ground.
PopulationParameters woody(const char* rule, double p) {
  PopulationParameters parameters;
  parameters.ground = {{0, 0}, {100, 100}};
  parameters.is_torus = false;
  parameters.rule = rule;
  parameters.competition.above_share = p;
  parameters.species.resize(2);
  parameters.species[0].name = "own";
  parameters.species[1].name = "neighbour";
  return parameters;
}

/// Sizes of plants that stand in a row, by the suite.
std::vector<Sizes> grown(const PopulationParameters& parameters,
                         const std::vector<StartPlant>& start, int count = steps) {
  Population population(parameters, sow(parameters, start), overlap_engine_named("all_pairs"));
  std::vector<Sizes> sizes(start.size());
  for (int t = 0; t <= count; ++t) {
    for (std::size_t k = 0; k < population.stand().size(); ++k)
      sizes[population.stand().id[k]].push_back(population.stand().stem_radius[k]);
    if (t < count) population.step();
  }
  return sizes;
}

Pair grown_pair(const PopulationParameters& parameters, double apart = distance,
                double second_radius = start_radius) {
  auto sizes =
      grown(parameters, {{{40, 50}, start_radius, 0}, {{40 + apart, 50}, second_radius, 1}});
  return {std::move(sizes[0]), std::move(sizes[1])};
}

Sizes grown_alone() {
  return grown(woody("none", 0), {{{40, 50}, start_radius, 0}})[0];
}

/// The same pair by the literal equations; the neighbour is ill from the start if the model knows
/// illness.
Pair literal_pair(const print::LiteralModel& model, bool is_ill = false) {
  print::LiteralStand stand(model, {{40, 50, start_radius, 0},
                                    {40 + distance, 50, start_radius, model.species.size() - 1}});
  if (is_ill) stand.fall_ill(1);
  for (int t = 0; t < steps; ++t) stand.step();
  return {stand.plants()[0].sizes, stand.plants()[1].sizes};
}

double largest_difference(const Pair& a, const Pair& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t t = 0; t < a[i].size(); ++t)
      largest = std::max(largest, std::abs(a[i][t] / b[i][t] - 1));
  return largest;
}

constexpr std::pair<char, double> kinds_of_roots[] = {{'f', 0.0}, {'c', 0.5}, {'t', 1.0}};

/// Figure 7.8: flat (f), medium (c) and deep (t) roots beside each other.
void record_roots(ExperimentContext& context) {
  std::vector<PlotPanel> panels;
  double off = 0.0;
  for (const auto& [own, own_rank] : kinds_of_roots)
    for (const auto& [other, other_rank] : kinds_of_roots) {
      PopulationParameters parameters = woody("roots", 0);
      parameters.species[0].traits.root_rank = own_rank;
      parameters.species[1].traits.root_rank = other_rank;
      print::LiteralModel model{.species = {{.rank = own_rank}, {.rank = other_rank}},
                                .zones = print::Zones::two,
                                .p = 0.0,
                                .has_roots = true};
      const Pair pair = grown_pair(parameters);
      off = std::max(off, largest_difference(pair, literal_pair(model)));
      model.as_printed.roots_of_pair = true;
      const Pair printed = literal_pair(model);
      const std::string name = fmt::format("roots/{}{}/", own, other);
      context.record(name + "own", pair[0].back(), "m");
      context.record(name + "neighbour", pair[1].back(), "m");
      context.record(name + "one_factor_per_pair/own", printed[0].back(), "m");
      context.record(name + "one_factor_per_pair/neighbour", printed[1].back(), "m");
      if (other != 't') continue;
      std::vector<double> time;
      for (int t = 0; t <= steps; ++t) time.push_back(t);
      const char* kind = own == 'f' ? "flat" : own == 'c' ? "medium" : "deep";
      panels.push_back(
          {.curves = {{.name = "roots named above", .x = time, .y = pair[0]},
                      {.name = "deep roots beside", .x = time, .y = pair[1]},
                      {.name = "alone", .x = time, .y = grown_alone(), .style = PlotStyle::dotted}},
           .caption = fmt::format("{} beside deep roots", kind),
           .x_label = "step",
           .y_label = "stem radius, m",
           .y_range = AxisRange{0.0, 0.5}});
    }
  context.record("roots/largest_difference_from_print", off);
  context.record("alone/after-80", grown_alone().back(), "m");
  add_plot(context, "roots-over-time",
           {.title = "Growth of two neighbours by their roots",
            .description = "Stem radius of a plant and of its deep-rooted neighbour over the "
                           "steps, one panel per kind of roots, and of the same plant alone: "
                           "flat roots stay farthest behind and hinder their neighbour least, "
                           "equal roots share the loss.",
            .panels = panels});
}

/// Figure 7.10: the plant that stays healthy, beside an ill one and others.
void record_illness(ExperimentContext& context) {
  PopulationParameters parameters = woody("disease", 0);
  const Pair healthy = grown_pair(parameters);
  parameters.events = {{.kind = EventKind::disease, .step = 0, .plants = {1}}};
  const Pair ill = grown_pair(parameters);
  print::LiteralModel model{.zones = print::Zones::two, .p = 0.0, .has_illness = true};
  const double off = largest_difference(ill, literal_pair(model, true));
  model.as_printed.illness_from_2s = true;
  const std::pair<const char*, Sizes> all[] = {{"none", grown_alone()},
                                               {"healthy", healthy[0]},
                                               {"ill", ill[0]},
                                               {"ill_as_printed", literal_pair(model, true)[0]}};
  const char* const names[] = {"no rival", "healthy rival", "ill rival, T_k from 0 to -s",
                               "ill rival, T_k from 2s to 0 (printed)"};
  PlotPanel panel{.curves = {},
                  .caption = "Two plants 8 m apart",
                  .x_label = "step",
                  .y_label = "stem radius of the healthy plant, m"};
  for (std::size_t i = 0; i < std::size(all); ++i) {
    const auto& [name, sizes] = all[i];
    for (const int t : {20, 40, 80})
      context.record(fmt::format("rival/{}/after-{}", name, t), sizes[static_cast<std::size_t>(t)],
                     "m");
    PlotCurve curve{.name = names[i],
                    .x = {},
                    .y = sizes,
                    .style = i == 0   ? PlotStyle::dotted
                             : i == 3 ? PlotStyle::dashed
                                      : PlotStyle::solid};
    for (int t = 0; t <= steps; ++t) curve.x.push_back(t);
    panel.curves.push_back(std::move(curve));
  }
  context.record("rival/largest_difference_from_print", off);
  add_plot(context, "beside-an-ill-plant",
           {.title = "Growth of a plant beside a healthy, an ill or no rival",
            .description = "Stem radius over the steps of the plant that stays healthy. It "
                           "grows best without a rival, and an ill rival hinders it less than a "
                           "healthy one does; with the printed bounds of the factor of illness "
                           "it hinders it more.",
            .panels = {panel}});
}

/// Figure 4.3: equal plants, and a smaller one, after half of the run.
void record_sizes(ExperimentContext& context) {
  const Sizes alone = grown_alone();
  for (const auto& [name, p] :
       {std::pair{"symmetric", 0.0}, std::pair{"mixed", 0.5}, std::pair{"asymmetric", 1.0}}) {
    const Pair equal = grown_pair(woody("mixture", p));
    const Pair unequal = grown_pair(woody("mixture", p), distance, 0.07);
    const std::string prefix = fmt::format("size/{}/", name);
    context.record(prefix + "equal/first", equal[0][40], "m");
    context.record(prefix + "equal/second", equal[1][40], "m");
    context.record(prefix + "smaller/growth", unequal[0][40] / start_radius);
    context.record(prefix + "larger/growth", unequal[1][40] / 0.07);
    context.record(prefix + "smaller/over_alone", unequal[0][40] / alone[40]);
  }
}

/// The first step of a small and a large neighbour, over that of a plant alone, where all of the
/// overlap goes to one: (4.3) as printed is what a plant wins, yet it reduces growth.
void record_direction(ExperimentContext& context) {
  const std::vector<print::LiteralPlant> plants{{0, 0, 0.05}, {5, 0, 0.07}};
  for (const bool as_printed : {false, true}) {
    print::LiteralStand stand({.p = 1.0, .as_printed = {.gain_as_loss = as_printed}}, plants);
    stand.step();
    for (const std::size_t i : {0u, 1u}) {
      const double R = plants[i].R, alone = print::equation_5_8(0.05, R, 0.5);
      context.record(fmt::format("direction/{}/{}", as_printed ? "printed" : "corrected",
                                 i == 0 ? "smaller" : "larger"),
                     (stand.plants()[i].R - R) / alone);
    }
  }
  const PopulationParameters parameters = woody("asymmetric", 1);
  const auto sizes = grown(parameters, {{{40, 50}, 0.05, 0}, {{45, 50}, 0.07, 0}}, 1);
  for (const std::size_t i : {0u, 1u}) {
    const double alone = print::equation_5_8(0.05, plants[i].R, 0.5);
    context.record(fmt::format("direction/suite/{}", i == 0 ? "smaller" : "larger"),
                   (sizes[i][1] - sizes[i][0]) / alone);
  }
}

/// The largest of sixty plants under purely asymmetric competition, and the same plant alone.
void record_largest(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  std::vector<StartPlant> plants{{{50, 50}, 0.08, 0}};
  while (plants.size() < 60)
    plants.push_back({{stream.next_between(35, 65), stream.next_between(35, 65)},
                      stream.next_between(0.03, 0.07),
                      0});
  const PopulationParameters parameters = woody("asymmetric", 1);
  const auto among = grown(parameters, plants);
  context.record("largest/among_others", among[0].back(), "m");
  context.record("largest/alone", grown(parameters, {plants[0]})[0].back(), "m");
  double others = 0.0;
  for (std::size_t i = 1; i < among.size(); ++i) others = std::max(others, among[i].back());
  context.record("largest/next_to_it", others, "m");
}

/// When the zones of two plants 10 m apart meet: by (5.8) as a differential equation (Runge-Kutta),
/// and the first step of the suite with a loss.
void record_first_contact(ExperimentContext& context) {
  const auto rate = [](double R) { return print::equation_5_8(0.05, R, 0.5); };
  for (const auto& [name, d] : {std::pair{"08", 8.0}, std::pair{"10", 10.0},
                                std::pair{"12-5", 12.5}, std::pair{"15", 15.0}}) {
    const double contact = (5.0 / d) * (5.0 / d);  // d sqrt R = 5 m
    constexpr double h = 0.01;
    double R = start_radius, time = 0.0, before = R;
    while (R < contact) {
      before = R;
      const double k1 = rate(R), k2 = rate(R + h / 2 * k1), k3 = rate(R + h / 2 * k2),
                   k4 = rate(R + h * k3);
      R += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      time += h;
    }
    context.record(fmt::format("first_contact/factor-{}/time", name),
                   time - h * (R - contact) / (R - before), "steps");
    PopulationParameters parameters = woody("symmetric", 0);
    for (Species& species : parameters.species) species.roots = {d, d, 0.5};
    Population population(parameters,
                          sow(parameters, std::vector<StartPlant>{{{40, 50}, start_radius, 0},
                                                                  {{50, 50}, start_radius, 1}}),
                          overlap_engine_named("all_pairs"));
    while (population.state().step < steps && population.losses()[0] == 0.0) population.step();
    context.record(fmt::format("first_contact/factor-{}/step", name),
                   static_cast<std::int64_t>(population.state().step), "steps");
  }
}

void run(ExperimentContext& context) {
  record_roots(context);
  record_illness(context);
  record_sizes(context);
  record_direction(context);
  record_largest(context);
  record_first_contact(context);
}

}  // namespace

extern const ExperimentDescriptor growing_pairs;
constinit const ExperimentDescriptor growing_pairs{
    .id = "alsweis/growing-pairs",
    .question = "Which of two neighbours grows better, by size, by roots, by health?",
    .source = "[Alsweis] fig. 4.3, 7.8, 7.10, sec. 4.7",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
