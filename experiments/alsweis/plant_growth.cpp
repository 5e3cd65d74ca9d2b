// SPDX-License-Identifier: MIT
// Growth of one plant: Richards' law, its members, and the rates that the text gives it.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/population/growth_integrators.hpp"
#include "core/population/richards_growth.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/golden_section.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

// Of figure 4.5, for there are none with (2.1); the start is that of its smaller plant.
constexpr double k = 0.1, w = 10.0, start = 1.0;

RichardsGrowth law_of(double shape) {
  return {k, w, shape};
}

/// Relative to the second, or to 1 where that is smaller.
double difference(double value, double exact) {
  return std::abs(value - exact) / std::max(1.0, std::abs(exact));
}

/// Closed form beside the printed law, which is integrated in small steps.
void record_sizes(ExperimentContext& context) {
  double runge_kutta = 0.0;
  for (const double shape : {0.5, 1.0, 2.0, 3.0}) {
    const auto rate = [&](double v) {
      return shape == 1.0 ? oracles::gompertz_rate(v, k, w) : oracles::equation_2_1(v, k, w, shape);
    };
    double v = start;
    for (const int time : {10, 20, 50}) {
      const int before = time == 10 ? 0 : time == 20 ? 10 : 20;
      v = integrated(RungeKutta4{}, v, time - before, static_cast<std::size_t>(time - before) * 100,
                     rate);
      const double size = richards_size(law_of(shape), start, time);
      runge_kutta = std::max(runge_kutta, difference(v, size));
      context.record(fmt::format("size/shape-{}/after-{}", shape, time), size);
    }
  }
  context.record("size/runge_kutta_difference", runge_kutta);
}

/// The suite's law beside the literal one, and its named members.
void record_agreement(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * stream.next_unit();
  };
  double rate = 0.0, size = 0.0, logistic = 0.0, saturating = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double rate_k = draw(0.01, 1), end = draw(1, 100), v = end * draw(0.01, 2);
    const double shape = draw(0, 1) < 0.5 ? draw(-2, 0.95) : draw(1.05, 5), time = draw(0, 50);
    const RichardsGrowth law{rate_k, end, shape};
    rate = std::max(
        rate, difference(richards_rate(law, v), oracles::equation_2_1(v, rate_k, end, shape)));
    size = std::max(size, difference(richards_size(law, v, time),
                                     oracles::solution_of_2_1(v, rate_k, end, shape, time)));
    logistic = std::max(logistic, difference(oracles::equation_2_1(v, rate_k, end, 2.0),
                                             rate_k * v * (1.0 - v / end)));
    saturating = std::max(
        saturating, difference(oracles::equation_2_1(v, rate_k, end, 0.0), rate_k * (end - v)));
  }
  context.record("agreement/rate_difference", rate);
  context.record("agreement/size_difference", size);
  context.record("members/logistic_difference", logistic);
  context.record("members/monomolecular_difference", saturating);
}

void record_final_size(ExperimentContext& context) {
  double rate = 0.0, slope = 0.0, limit = 0.0;
  for (const double shape : {-1.0, 0.0, 0.5, 1.5, 2.0, 3.0, 5.0}) {
    const double h = 1e-5;
    rate = std::max(rate, std::abs(oracles::equation_2_1(w, k, w, shape)));
    slope = std::max(slope, std::abs((oracles::equation_2_1(w + h, k, w, shape) -
                                      oracles::equation_2_1(w - h, k, w, shape)) /
                                         (2.0 * h) +
                                     k));
    for (const double v : {0.01, 1.0, 30.0})
      limit = std::max(limit, std::abs(richards_size(law_of(shape), v, 2000.0) / w - 1.0));
  }
  context.record("final-size/rate", rate);
  context.record("final-size/slope_beside_minus_k", slope);
  context.record("final-size/distance_after_long", limit);
}

/// Growth over size of ever smaller plants, beside the printed k / (delta - 1).
void record_initial_rates(ExperimentContext& context) {
  for (const double shape : {1.5, 2.0, 3.0, 0.5}) {
    const std::string name = fmt::format("initial/shape-{}", shape);
    context.record(name + "/printed", oracles::initial_rate_as_printed(k, shape), "per time");
    context.record(name + "/vanishing", oracles::relative_rate(1e-12 * w, k, w, shape), "per time");
  }
  for (const int power : {3, 6, 12})
    context.record(fmt::format("initial/shape-0.5/size-1e-{}", power),
                   oracles::relative_rate(std::pow(10.0, -power), k, w, 0.5), "per time");
  context.record("initial/shape-2/absolute_rate", oracles::equation_2_1(1e-12 * w, k, w, 2.0));
  context.record("relative-rate/shape-2/half_of_final_size",
                 oracles::relative_rate(0.5 * w, k, w, 2.0), "per time");
  context.record("relative-rate/shape-2/final_size", std::abs(oracles::relative_rate(w, k, w, 2.0)),
                 "per time");
}

/// How fast growth of shapes near 1 nears Gompertz' law.
void record_gompertz(ExperimentContext& context) {
  const double gompertz = oracles::gompertz_solution(start, k, w, 20.0);
  context.record("gompertz/after-20", gompertz);
  for (const int power : {2, 3, 4, 5}) {
    const double bend = std::pow(10.0, -power);
    context.record(fmt::format("gompertz/bend-{}", power), bend);
    context.record(fmt::format("gompertz/difference-{}", power),
                   std::abs(richards_size(law_of(1.0 + bend), start, 20.0) - gompertz));
  }
  double rate = 0.0;
  for (const double v : {0.01, 1.0, 9.0, 15.0})
    rate = std::max(
        rate, difference(richards_rate(law_of(1.0 + 1e-14), v), oracles::gompertz_rate(v, k, w)));
  context.record("gompertz/rate_difference_at_once", rate);
}

void record_inflections(ExperimentContext& context) {
  double beside = 0.0;
  for (const double shape : {0.5, 1.0, 2.0, 3.0}) {
    const RichardsGrowth law = law_of(shape);
    const auto rate = [&](double v) { return richards_rate(law, v); };
    const double found = place_of_highest(rate, 1e-9 * w, w);
    const std::string name = fmt::format("inflection/shape-{}", shape);
    context.record(name + "/size", *richards_inflection_size(law));
    context.record(name + "/rate", *richards_largest_rate(law), "size per time");
    context.record(name + "/found_rate", rate(found), "size per time");
    beside = std::max(beside, std::abs(found - *richards_inflection_size(law)));
  }
  context.record("inflection/distance_of_found", beside);
  // Without an inflection growth is the faster the smaller the plant.
  const auto fastest = [](double shape) {
    return place_of_highest([&](double v) { return richards_rate(law_of(shape), v); }, 1e-9 * w, w);
  };
  context.record("inflection/shape-0/found_size", fastest(0.0));
  context.record("inflection/shape-minus-1/found_size", fastest(-1.0));
}

/// The mean rate over all sizes from 0 to w, by the midpoint rule in the root of the size.
void record_mean_rates(ExperimentContext& context) {
  double worst = 0.0;
  for (const double shape : {0.5, 1.0, 2.0, 3.0, 5.0}) {
    constexpr int pieces = 50'000;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      const double root = std::sqrt(w) * (i + 0.5) / pieces;
      sum += richards_rate(law_of(shape), root * root) * 2.0 * root;
    }
    const double mean = sum * std::sqrt(w) / pieces / w;
    worst = std::max(worst, std::abs(mean / (k * w / (2.0 * (shape + 1.0))) - 1.0));
  }
  context.record("mean-rate/largest_relative_error", worst);
}

/// Shapes in small steps: how often a curve is not below that of the shape before.
void record_order(ExperimentContext& context) {
  int not_below = 0;
  for (const double time : {10.0, 20.0, 50.0})
    for (int i = 0; i < 100; ++i)
      not_below += !(richards_size(law_of(0.05 * (i + 1)), start, time) <
                     richards_size(law_of(0.05 * i), start, time));
  context.record("order/not_below", not_below);
}

/// Figure 2.1 with shapes of ours, and beside it the growth rates.
void draw_figure(ExperimentContext& context) {
  PlotPanel sizes{.curves = {}, .caption = "a) size", .x_label = "time", .y_label = "size v"};
  PlotPanel rates{.curves = {},
                  .caption = "b) growth",
                  .x_label = "size v",
                  .y_label = "dv/dt",
                  .x_range = AxisRange{0.0, w}};
  for (const double shape : {0.0, 0.5, 1.0, 2.0, 3.0, 5.0}) {
    PlotCurve size{.name = fmt::format("δ = {}", shape), .x = {}, .y = {}};
    PlotCurve rate = size;
    for (int i = 0; i <= 400; ++i) {
      size.x.push_back(0.25 * i);
      size.y.push_back(richards_size(law_of(shape), start, size.x.back()));
      rate.x.push_back(std::max(1e-6, w * i / 400.0));
      rate.y.push_back(richards_rate(law_of(shape), rate.x.back()));
    }
    sizes.curves.push_back(std::move(size));
    rates.curves.push_back(std::move(rate));
  }
  add_plot(context, "figure-2.1",
           {.title = "Figure 2.1: Richards' law for several shapes",
            .description = "Size over time, and growth over size, for six shapes δ of ours with "
                           "w = 10 and k = 0.1: every plant nears size 10, with a turning point "
                           "that lies the higher the larger δ.",
            .panels = {sizes, rates}});
}

void run(ExperimentContext& context) {
  record_sizes(context);
  record_agreement(context);
  record_final_size(context);
  record_initial_rates(context);
  record_gompertz(context);
  record_inflections(context);
  record_mean_rates(context);
  record_order(context);
  draw_figure(context);
}

}  // namespace

extern const ExperimentDescriptor plant_growth;
constinit const ExperimentDescriptor plant_growth{
    .id = "alsweis/plant-growth",
    .question = "How does a plant without neighbours grow, and which rate does the text give it?",
    .source = "[Alsweis] (2.1), fig. 2.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
