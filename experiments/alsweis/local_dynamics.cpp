// SPDX-License-Identifier: MIT
// One cell: the discrete logistic equation, how it is written out, and what it does in the long
// run.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/population/logistic_map.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_population.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::population;

constexpr double K = 100.0;

LogisticMap map_of(double fertility) {
  return LogisticMap::of_rate(1.0 + fertility, K);
}

/// The equations beside each other, on random rates, capacities and counts; differences over K.
void record_forms(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  double expanded = 0.0, mortality = 0.0, ours = 0.0, equal_at_one = 0.0, least_off = 1.0;
  constexpr int draws = 1000;
  for (int i = 0; i < draws; ++i) {
    const double r = stream.next_between(0.0, 4.0), k = stream.next_between(1.0, 1000.0);
    const double n = k * (1.0 - stream.next_unit());
    const double exact = oracles::equation_2_9(r, k, n);
    expanded = std::max(expanded, std::abs(oracles::equation_2_11(r - 1.0, -r / k, n) - exact) / k);
    mortality = std::max(mortality, std::abs(-r / k + (1.0 + (r - 1.0)) / k) * k);
    ours = std::max(ours, std::abs(LogisticMap::of_rate(r, k).next(n) - exact) / k);
    equal_at_one = std::max(equal_at_one, std::abs(oracles::equation_2_10_as_printed(1.0, k, n) -
                                                   oracles::equation_2_9(1.0, k, n)) /
                                              k);
    // Elsewhere the printed form is off by 2 (1 - r) N.
    const double off = oracles::equation_2_10_as_printed(r, k, n) - exact;
    least_off = std::min(least_off, std::abs(off / (2.0 * (1.0 - r) * n)));
  }
  const auto record = [&](const char* name, double value) {
    context.record({.experiment = {},
                    .measurement = std::string("forms/") + name,
                    .value = value,
                    .sample_size = draws,
                    .seed = context.seed()});
  };
  record("difference_2.11", expanded);
  record("difference_beta", mortality);
  record("difference_of_suite", ours);
  record("difference_2.10_at_rate_1", equal_at_one);
  record("least_share_of_2.10_off", least_off);
}

/// (2.10) as printed, beside (2.9).
void record_printed(ExperimentContext& context) {
  for (const auto& [name, r] : {std::pair{"rate-1.2", 1.2}, std::pair{"rate-2", 2.0}}) {
    context.record(fmt::format("printed/{}/equation_2.10", name),
                   oracles::equation_2_10_as_printed(r, K, 10.0), "plants");
    context.record(fmt::format("printed/{}/equation_2.9", name), oracles::equation_2_9(r, K, 10.0),
                   "plants");
  }
  double printed = 10.0, exact = 10.0;
  for (int t = 0; t < 1000; ++t) {
    printed = oracles::equation_2_10_as_printed(1.2, K, printed);
    exact = oracles::equation_2_9(1.2, K, exact);
  }
  context.record("printed/rate-1.2/count_after_1000_years", printed, "plants");
  context.record("printed/rate-1.2/count_of_2.9_after_1000_years", exact, "plants");
  const double fixed = K * (1.0 - 1.2) / 1.2;
  context.record("printed/rate-1.2/fixed_count", fixed, "plants");
  context.record("printed/rate-1.2/move_from_fixed_count",
                 oracles::equation_2_10_as_printed(1.2, K, fixed) - fixed, "plants");
}

void record_equilibria(ExperimentContext& context) {
  for (const double fertility : {0.2, 0.3, 1.0, 1.9}) {
    const LogisticMap map = map_of(fertility);
    const std::string name = fmt::format("equilibrium/alpha-{}", fertility);
    context.record(name + "/count", map.equilibrium(), "plants");
    const std::vector<double> from_afar = orbit(map, 10.0, 10'000);
    context.record(name + "/count_after_10000_years", from_afar.back(), "plants");
    double moved = 0.0;
    for (const double count : orbit(map, map.equilibrium(), 10'000))
      moved = std::max(moved, std::abs(count - map.equilibrium()));
    context.record(name + "/largest_move_in_10000_years", moved, "plants");
    context.record(name + "/multiplier", map.multiplier(map.equilibrium()));
  }
  // At rate 1 a count falls as slowly as K / t.
  for (const auto& [rate, years] :
       {std::pair{0.5, 500u}, std::pair{0.9, 500u}, std::pair{1.0, 100'000u}})
    context.record(fmt::format("extinction/rate-{}/last_count", rate),
                   orbit(LogisticMap::of_rate(rate, K), 50.0, years).back(), "plants");
}

/// What K bounds: the largest of all counts that the map can give, and of those that it keeps to.
void record_capacity(ExperimentContext& context) {
  for (const double rate : {1.2, 2.0, 3.0, 3.9, 4.0}) {
    const LogisticMap map = LogisticMap::of_rate(rate, K);
    double largest = 0.0, least = K;
    for (int i = 0; i <= 10'000; ++i) {
      const double next = map.next(K * i / 10'000.0);
      largest = std::max(largest, next);
      least = std::min(least, next);
    }
    const std::string name = fmt::format("capacity/rate-{}", rate);
    context.record(name + "/largest_next", largest, "plants");
    context.record(name + "/least_next", least, "plants");
    context.record(name + "/next_of_capacity", map.next(K), "plants");
  }
}

void record_long_run(ExperimentContext& context) {
  for (const double fertility :
       {0.1, 0.2, 0.3, 0.5, 1.0, 1.5, 1.9, 2.2, 2.45, 2.5, 2.55, 2.57, 2.8, 2.835, 3.0}) {
    const LogisticMap map = map_of(fertility);
    const std::string name = fmt::format("long-run/alpha-{}", fertility);
    const auto period = attractor_period(map);
    context.record(name + "/period", period ? fmt::format("{}", *period) : std::string("none"),
                   "years");
    if (fertility == 1.0) continue;  // minus infinity
    context.record(name + "/lyapunov_exponent", lyapunov_exponent(map), "1/year");
  }
}

/// Up to which fertility the period is `period`, by bisection between two that are given.
double period_holds_until(std::size_t period, double low, double high) {
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (attractor_period(map_of(middle)) == period ? low : high) = middle;
  }
  return low;
}

void record_thresholds(ExperimentContext& context) {
  context.record("thresholds/one_count_until", period_holds_until(1, 1.5, 2.2));
  context.record("thresholds/two_counts_until", period_holds_until(2, 2.2, 2.5));
  std::array<double, 11> middle{};
  for (std::size_t k = 0; k < middle.size(); ++k) {
    middle[k] = superstable_fertility(k);
    context.record(fmt::format("thresholds/superstable/doublings-{}", k), middle[k]);
  }
  const double gap = middle[10] - middle[9], before = middle[9] - middle[8];
  context.record("thresholds/feigenbaum_ratio", before / gap);
  context.record("thresholds/chaos_from", middle[10] + gap * gap / (before - gap));
}

/// How many of the fertilities that the text calls chaotic are.
void record_share_of_chaos(ExperimentContext& context) {
  const int count = context.tier() == Tier::full ? 27'000 : 2'700;
  const OrbitOptions options{.transient = 5000, .years = 8192};
  int chaotic = 0;
  for (int i = 0; i < count; ++i) {
    if (i % 100 == 0) context.progress(fmt::format("fertility {} of {}", i, count));
    // Off the grid of round numbers, at which exponents may be infinite.
    const double fertility = 0.3 + 2.7 * (i + 0.5) / count;
    chaotic += lyapunov_exponent(map_of(fertility), options) > 0.0;
  }
  context.record({.experiment = {},
                  .measurement = "chaos/share_of_fertilities_0.3_to_3",
                  .value = static_cast<double>(chaotic) / count,
                  .sample_size = count});
}

/// Figure 2.5 names neither parameters nor what makes plants old: counts of (2.11) instead.
void draw_orbits(ExperimentContext& context) {
  const auto panel = [](const char* caption, const std::vector<double>& fertilities) {
    PlotPanel all{.caption = caption, .x_label = "years", .y_label = "plants N(t), K = 100"};
    for (const double fertility : fertilities) {
      PlotCurve curve{.name = fmt::format("α = {}", fertility)};
      curve.y = orbit(map_of(fertility), 5.0, 40);
      for (std::size_t t = 0; t < curve.y.size(); ++t) curve.x.push_back(static_cast<double>(t));
      all.curves.push_back(curve);
    }
    all.y_range = AxisRange{0.0, 100.0};
    return all;
  };
  add_plot(context, "figure-2.5",
           {.title = "Local population dynamics (2.11) instead of figure 2.5",
            .description = "Counts of plants over 40 years from five plants; the parameters of the "
                           "published figure are unknown. Up to a fertility of 2 counts settle "
                           "below the capacity of 100, above it they swing.",
            .panels = {panel("settles", {0.2, 0.3, 1.9}), panel("swings", {2.2, 2.57})}});
}

/// One column of the diagram: a point at every height that an orbit visits.
void add_visited(double fertility, PlotCurve& curve) {
  constexpr std::size_t heights = 90;  // so many fit the plot
  std::array<bool, heights> visited{};
  const LogisticMap map = LogisticMap::of_rate(1.0 + fertility, 1.0);
  double count = orbit(map, OrbitOptions{}.start, 3000).back();
  for (int t = 0; t < 200; ++t, count = map.next(count)) {
    const auto height = std::min(static_cast<std::size_t>(count * heights), heights - 1);
    if (std::exchange(visited[height], true)) continue;
    curve.x.push_back(fertility);
    curve.y.push_back(count);
  }
}

void draw_bifurcations(ExperimentContext& context) {
  constexpr int columns = 105;
  constexpr double from = 1.5, to = 3.0;
  PlotCurve visited{.name = "counts", .style = PlotStyle::points};
  PlotCurve exponent{.name = "Lyapunov exponent"};
  for (int i = 0; i <= columns; ++i) add_visited(from + (to - from) * i / columns, visited);
  constexpr double floor = -2.0;  // exponents fall to minus infinity in every window
  for (int i = 0; i <= 6 * columns; ++i) {
    exponent.x.push_back(from + (to - from) * i / (6.0 * columns));
    exponent.y.push_back(std::max(
        floor, lyapunov_exponent(map_of(exponent.x.back()), {.transient = 2000, .years = 4096})));
  }
  const PlotCurve zero{
      .name = "zero", .x = {from, to}, .y = {0.0, 0.0}, .style = PlotStyle::dotted};
  const PlotPanel left{.curves = {visited},
                       .caption = "counts in the long run",
                       .x_label = "fertility α",
                       .y_label = "N / K",
                       .y_range = AxisRange{0.0, 1.0}};
  const PlotPanel right{.curves = {zero, exponent},
                        .caption = "above 0: chaos",
                        .x_label = "fertility α",
                        .y_label = "exponent, 1/year",
                        .y_range = AxisRange{floor, 1.0}};
  add_plot(
      context, "bifurcations",
      {.title = "Long run of the logistic map (2.11)",
       .description = "Left, the counts that a population visits in the long run: one, then "
                      "two from a fertility of 2, four from 2.45, and a whole band of them "
                      "beyond 2.57, with windows. Right, the Lyapunov exponent, cut off at -2: "
                      "above 0 the course is chaotic.",
       .panels = {left, right}});
}

void run(ExperimentContext& context) {
  record_forms(context);
  record_printed(context);
  record_equilibria(context);
  record_capacity(context);
  record_long_run(context);
  record_thresholds(context);
  record_share_of_chaos(context);
  draw_orbits(context);
  draw_bifurcations(context);
}

}  // namespace

extern const ExperimentDescriptor local_dynamics;
constinit const ExperimentDescriptor local_dynamics{
    .id = "alsweis/local-dynamics",
    .question = "What becomes of a population that follows the discrete logistic equation?",
    .source = "[Alsweis] (2.9) to (2.11), figure 2.5",
    .seconds = {1, 1, 3},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
