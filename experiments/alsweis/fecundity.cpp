// SPDX-License-Identifier: MIT
// Seeds of plants that grow and of plants in a crowd: the laws of section 2.3.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/population/density_laws.hpp"
#include "core/population/richards_growth.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/reduced_major_axis.hpp"
#include "experiments/alsweis/golden_section.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

/// The suite's laws beside the literal ones, at random points.
void record_agreement(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * stream.next_unit();
  };
  double linear = 0.0, crowded = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double w = draw(0, 10), b_0 = draw(0, 5), b_1 = draw(0, 5);
    linear = std::max(
        linear, std::abs(linear_fecundity(w, b_0, b_1) / oracles::equation_2_4(w, b_0, b_1) - 1.0));
    const double x = draw(0, 1000), a = draw(0.1, 3), b = draw(0, 2), phi = draw(0.2, 3),
                 theta = draw(0.2, 3);
    crowded = std::max(crowded, std::abs(seeds_per_plant({a, b, phi, theta}, x) /
                                             oracles::equation_2_5(x, a, b, phi, theta) -
                                         1.0));
  }
  context.record("agreement/linear_difference", linear);
  context.record("agreement/crowded_difference", crowded);
}

/// A plant that grows logistically, and its seeds by (2.4).
constexpr double b_0 = 4.0, b_1 = 2.0;
constexpr double end_of_growth = 80.0;

double seeds_of_weight(double w) {
  return oracles::equation_2_4(w, b_0, b_1);
}

double seeds_at(double time) {
  return seeds_of_weight(richards_size({0.1, 10.0, 2.0}, 1.0, time));
}

/// How far seeds lie from the straight line between both ends, at most, in parts of their rise.
template <class Seeds>
double distance_from_line(const Seeds& seeds, double end) {
  constexpr int pieces = 64;  // a power of two: no rounding
  const double first = seeds(0.0), rise = seeds(end) - first;
  double farthest = 0.0;
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    farthest = std::max(farthest, std::abs(seeds(share * end) - first - share * rise));
  }
  return farthest / rise;
}

/// (2.4) over weight, as the text has it, and over time, as the caption of figure 2.2 has it.
void record_linear_fecundity(ExperimentContext& context) {
  context.record("linear/distance_from_line_over_weight", distance_from_line(seeds_of_weight, 8.0));
  context.record("linear/distance_from_line_over_time",
                 distance_from_line(seeds_at, end_of_growth));
}

void draw_figure(ExperimentContext& context) {
  PlotPanel weight{
      .curves = {{.name = "seeds", .x = {0, 10}, .y = {seeds_of_weight(0), seeds_of_weight(10)}}},
      .caption = "a) over weight, as the text says",
      .x_label = "weight w",
      .y_label = "seeds b",
      .y_range = AxisRange{0, 25}};
  PlotPanel time{.curves = {{.name = "seeds", .x = {}, .y = {}}},
                 .caption = "b) over time, as the caption says",
                 .x_label = "time",
                 .y_label = "seeds b",
                 .y_range = AxisRange{0, 25}};
  for (int t = 0; t <= end_of_growth; ++t) {
    time.curves[0].x.push_back(t);
    time.curves[0].y.push_back(seeds_at(t));
  }
  add_plot(
      context, "figure-2.2",
      {.title = "Figure 2.2: seeds are linear in weight, not in time",
       .description = "Over weight the seeds b = 4 + 2 w lie on a straight line; over time they "
                      "follow the S of the plant's logistic growth.",
       .panels = {weight, time}});
}

/// (2.5) as a straight line in its own scales.
void record_crowded_fecundity(ExperimentContext& context) {
  constexpr double alpha = 0.7, beta = 0.2, phi = 1.5, theta = 0.8;
  std::vector<double> x, y;
  int not_below = 0;
  for (int i = 1; i <= 50; ++i) {
    const double density = 0.5 * i, seeds = oracles::equation_2_5(density, alpha, beta, phi, theta);
    not_below += !(seeds < oracles::equation_2_5(density - 0.5, alpha, beta, phi, theta));
    x.push_back(std::pow(density, phi));
    y.push_back(std::pow(seeds, -theta));
  }
  const StraightLine line = least_squares_line(x, y).value();
  context.record("crowded/line/slope_over_beta", line.slope / beta);
  context.record("crowded/line/intercept_over_alpha", line.intercept / alpha);
  context.record("crowded/line/unexplained", 1.0 - line.r_squared);
  context.record("crowded/not_below", not_below);
}

/// What alpha does: seeds of a plant alone, and the share of them that is left at density 1.
void record_meaning_of_alpha(ExperimentContext& context) {
  for (const double a : {0.5, 1.0, 2.0}) {
    const double alone = oracles::equation_2_5(0, a, 1.0, 1.0, 1.0);
    context.record(fmt::format("crowded/alone/alpha-{}", a), alone);
    context.record(fmt::format("crowded/left/alpha-{}", a),
                   oracles::equation_2_5(1, a, 1.0, 1.0, 1.0) / alone);
  }
  for (const double b : {0.5, 1.0, 2.0}) {
    const double alone = oracles::equation_2_5(0, 1.0, b, 1.0, 1.0);
    context.record(fmt::format("crowded/alone/beta-{}", b), alone);
    context.record(fmt::format("crowded/left/beta-{}", b),
                   oracles::equation_2_5(1, 1.0, b, 1.0, 1.0) / alone);
  }
}

/// Seeds per area.
void record_yield(ExperimentContext& context) {
  const CrowdedFecundity humped{.isolation = 1.0, .crowding = 0.5, .density_exponent = 2.0},
      even{.isolation = 1.0, .crowding = 0.25};
  const auto seeds = [&](double density) {
    return density * oracles::equation_2_5(density, 1.0, 0.5, 2.0, 1.0);
  };
  const double best = place_of_highest(seeds, 0.0, 10.0);
  context.record("yield/best_density", best);
  context.record("yield/most_seeds", seeds(best));
  context.record("yield/best_density_of_formula", density_of_most_seeds(humped).value());
  context.record("yield/limit_at_equal_exponents",
                 1e15 * oracles::equation_2_5(1e15, 1.0, 0.25, 1.0, 1.0));
  context.record("yield/limit_of_formula", limit_of_seeds_per_area(even).value());
}

/// (2.5) as the fecundity of plants whose weight follows from density in the same way.
void record_link(ExperimentContext& context) {
  double linked = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double weight = oracles::equation_2_5(i, 0.7, 0.2, 1.5, 0.8);
    linked = std::max(linked, std::abs(oracles::equation_2_4(weight, 0.0, 1.0) - weight));
  }
  context.record("link/difference_without_constant", linked);
  const double crowded = oracles::equation_2_5(1e12, 0.7, 0.2, 1.5, 0.8);
  context.record("link/seeds_in_a_crowd", crowded);
  context.record("link/seeds_in_a_crowd_with_constant_1", oracles::equation_2_4(crowded, 1.0, 1.0));
}

void run(ExperimentContext& context) {
  record_agreement(context);
  record_linear_fecundity(context);
  draw_figure(context);
  record_crowded_fecundity(context);
  record_meaning_of_alpha(context);
  record_yield(context);
  record_link(context);
}

}  // namespace

extern const ExperimentDescriptor fecundity;
constinit const ExperimentDescriptor fecundity{
    .id = "alsweis/fecundity",
    .question = "How many seeds do plants have that grow, and that stand in a crowd?",
    .source = "[Alsweis] (2.4), (2.5), fig. 2.2",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
