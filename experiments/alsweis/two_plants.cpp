// SPDX-License-Identifier: MIT
// Two plants that share all of their ground: the corrected growth law of section 4.3, figure 4.5,
// and what asymmetry does to the sizes in which they end.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/population/coupled_growth.hpp"
#include "core/population/growth_integrators.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/gini.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

// Of figure 4.5.
constexpr double k = 0.1, w = 10.0;
constexpr oracles::TwoPlants start{1.0, 2.0};

/// All of their ground shared, phi = 1, in steps of a hundredth.
std::vector<double> grown(const CoupledGrowth& law, std::vector<double> sizes, double time) {
  const OverlapShares shares = OverlapShares::complete(sizes.size());
  const auto steps = static_cast<std::size_t>(std::llround(100.0 * time));
  return integrated(
      RungeKutta4{}, std::move(sizes), time, steps,
      [&](const std::vector<double>& v) { return coupled_growth_rates(law, shares, v); });
}

/// The suite's law beside the literal one with its corrections, for three plants.
void record_agreement(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * stream.next_unit();
  };
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double delta = i % 4 == 0 ? 1.0 : draw(1.1, 4), a = draw(0, 2.5), end = draw(5, 20);
    const std::vector<double> v{draw(0.1, 6), draw(0.1, 6), draw(0.1, 6)};
    const double s_1 = draw(0, 1), s_2 = draw(0, 1);
    const OverlapShares shares(3, {1, s_1, s_2, 0.5, 1, 0.5, 0, 0, 1});
    const double ours = coupled_growth_rates({k, end, delta, a}, shares, v)[0];
    const double sum = oracles::sum_4_3_corrected(v[0], {v[1], v[2]}, {s_1, s_2});
    const double literal = oracles::section_4_3(v[0], sum, k, end, delta, a);
    worst = std::max(worst, std::abs(ours - literal) / std::max(1.0, std::abs(literal)));
  }
  context.record("agreement/rate_difference", worst);
}

struct Line {
  const char* name;
  double rate, asymmetry;
};
constexpr Line full{"full", 0.1, 1.0}, dashed{"dashed", 0.0667, 1.0},
    inferred{"inferred", 0.0667, 2.0};

/// Figure 4.5 at some times, and its ends.
void record_figure(ExperimentContext& context) {
  double worst = 0.0;
  for (const Line& line : {full, dashed, inferred}) {
    const CoupledGrowth law{line.rate, w, 2.0, line.asymmetry};
    for (const int time : {10, 20, 50}) {
      const auto v = grown(law, {start.v_1, start.v_2}, time);
      const auto literal =
          oracles::run_figure_4_5(start, line.rate, w, 2.0, line.asymmetry, time, 0.001);
      const std::string name = fmt::format("figure/{}/after-{}", line.name, time);
      context.record(name + "/first", v[0]);
      context.record(name + "/second", v[1]);
      worst = std::max({worst, std::abs(literal.v_1 / v[0] - 1), std::abs(literal.v_2 / v[1] - 1)});
    }
    const auto [first, second] = end_sizes_of_two(w, line.asymmetry, {start.v_1, start.v_2});
    const std::string name = fmt::format("figure/{}/end", line.name);
    context.record(name + "/first", first);
    context.record(name + "/second", second);
    const auto late = grown(law, {start.v_1, start.v_2}, 400.0);
    context.record(name + "/distance_after_long",
                   std::max(std::abs(late[0] - first), std::abs(late[1] - second)));
  }
  // The asymmetry at which a plant of the mean size grows as fast as on the full line.
  context.record("figure/inferred/asymmetry", std::log(0.1 * 1.5 / 0.0667) / std::log(1.5));
  context.record("figure/literal_difference", worst);
}

/// What two plants keep for ever that share everything.
void record_invariant(ExperimentContext& context) {
  double worst = 0.0;
  for (const double shape : {0.5, 1.0, 2.0, 3.0})
    for (const double a : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
      const auto v = grown({0.05, w, shape, a}, {start.v_1, start.v_2}, 50.0);
      const auto kept = [a](double first, double second) {
        if (a == 1.0) return first / second;
        return std::pow(first, 1.0 - a) - std::pow(second, 1.0 - a);
      };
      worst = std::max(worst, std::abs(kept(v[0], v[1]) / kept(start.v_1, start.v_2) - 1.0));
    }
  context.record("invariant/largest_relative_drift", worst);
}

/// (4.5), and how unequal two plants end.
void record_asymmetry(ExperimentContext& context) {
  double scaling = 0.0, suite = 0.0, near_0 = 0.0;
  for (int i = 0; i <= 60; ++i)
    for (const double v : {0.01, 1.0, 7.0, 300.0}) {
      const double a = i * 0.05, c = 3.0, f = oracles::equation_4_5(v, a);
      scaling =
          std::max(scaling, std::abs(oracles::equation_4_5(c * v, a) / (std::pow(c, a) * f) - 1.0));
      suite = std::max(suite, std::abs(size_factor(v, a) / f - 1.0));
      near_0 = std::max(near_0, std::abs(oracles::equation_4_5(v, 1e-9) - 1.0));
    }
  context.record("factor/at_a_0", oracles::equation_4_5(7.0, 0.0));
  context.record("factor/at_a_1", oracles::equation_4_5(7.0, 1.0));
  context.record("factor/scaling_difference", scaling);
  context.record("factor/suite_difference", suite);
  context.record("factor/jump_at_a_0", near_0);
  context.record("gini/start", gini_coefficient(std::vector{start.v_1, start.v_2}));
  for (const double a : {0.0, 0.5, 0.999, 1.0, 1.001, 1.5, 2.0, 3.0, 10.0}) {
    const auto [first, second] = end_sizes_of_two(w, a, {start.v_1, start.v_2});
    context.record(fmt::format("gini/end/asymmetry-{}", a),
                   gini_coefficient(std::vector{first, second}));
  }
}

void draw_figure(ExperimentContext& context) {
  PlotPanel printed{.curves = {},
                    .caption = "a) as printed",
                    .x_label = "time",
                    .y_label = "size",
                    .y_range = AxisRange{0, w}};
  PlotPanel meant = printed;
  meant.caption = "b) a = 2 for the dashed lines";
  for (const auto& [panel, line, style] :
       {std::tuple{&printed, full, PlotStyle::solid},
        std::tuple{&printed, dashed, PlotStyle::dashed}, std::tuple{&meant, full, PlotStyle::solid},
        std::tuple{&meant, inferred, PlotStyle::dashed}}) {
    PlotCurve first{
        .name = fmt::format("{}, a = {}, k = {}", "smaller plant", line.asymmetry, line.rate),
        .x = {},
        .y = {},
        .style = style,
        .colour = 0};
    PlotCurve second{
        .name = fmt::format("{}, a = {}, k = {}", "larger plant", line.asymmetry, line.rate),
        .x = {},
        .y = {},
        .style = style,
        .colour = 1};
    std::vector<double> v{start.v_1, start.v_2};
    for (int time = 0; time <= 100; ++time) {
      first.x.push_back(time);
      second.x.push_back(time);
      first.y.push_back(v[0]);
      second.y.push_back(v[1]);
      v = grown({line.rate, w, 2.0, line.asymmetry}, v, 1.0);
    }
    panel->curves.push_back(std::move(first));
    panel->curves.push_back(std::move(second));
  }
  add_plot(context, "figure-4.5",
           {.title = "Figure 4.5: two plants that press each other",
            .description = "Size over time of two plants that start at sizes 1 and 2, with w = 10: "
                           "left with the asymmetry 1 that the caption gives for both lines, right "
                           "with 2 for the dashed ones.",
            .panels = {printed, meant}});
}

void run(ExperimentContext& context) {
  record_agreement(context);
  record_figure(context);
  record_invariant(context);
  record_asymmetry(context);
  draw_figure(context);
}

}  // namespace

extern const ExperimentDescriptor two_plants;
constinit const ExperimentDescriptor two_plants{
    .id = "alsweis/two-plants",
    .question =
        "How do two plants grow that share all of their ground, and how unequal do they end?",
    .source = "[Alsweis] sec. 4.3, (4.5), fig. 4.5",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
