// SPDX-License-Identifier: MIT
// The growth law of section 4.3 as printed, beside what is meant: which plant is pressed, what is
// summed, in which unit, and what is left of it without neighbours.
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

// Of figure 4.5.
constexpr double k = 0.1, w = 10.0;
constexpr oracles::TwoPlants start{1.0, 2.0};

/// How far the branch with powers is from the one with logarithms, for shapes near 1.
void record_branches(ExperimentContext& context) {
  const double sum = start.v_1 + start.v_2;
  const double at_1 = oracles::section_4_3(start.v_1, sum, k, w, 1.0, 1.0);
  for (const int power : {2, 3, 4, 5}) {
    const double bend = std::pow(10.0, -power);
    const double beside = oracles::section_4_3(start.v_1, sum, k, w, 1.0 + bend, 1.0);
    context.record(fmt::format("branches/bend-{}", power), bend);
    context.record(fmt::format("branches/difference-{}", power), std::abs(beside - at_1));
  }
}

/// Asymmetric competition, p = 1, over the whole area of both, gamma = 1.
void record_printed_law(ExperimentContext& context) {
  for (const double step : {0.01, 0.001})
    for (const int time : {20, 30, 40, 60}) {
      const auto v = oracles::run_4_3(start, k, w, 1.0, time, step, true);
      const std::string name = fmt::format("printed/step-{}/after-{}", step, time);
      context.record(name + "/first", v.v_1);
      context.record(name + "/second", v.v_2);
    }
  for (const int time : {20, 30, 40, 60}) {
    const auto v = oracles::run_4_3(start, k, w, 1.0, time, 0.01, false);
    context.record(fmt::format("meant/after-{}/first", time), v.v_1);
    context.record(fmt::format("meant/after-{}/second", time), v.v_2);
  }
  const auto end = oracles::run_4_3(start, k, w, 1.0, 200.0, 0.01, true);
  context.record("printed/end/first_over_w", end.v_1 / w);
  context.record("printed/end/second_over_w", end.v_2 / w);
  double time = 0.0;
  for (auto v = start; v.v_1 < v.v_2; time += 0.001)
    v = oracles::run_4_3(v, k, w, 1.0, 0.001, 0.001, true);
  context.record("printed/crossing_time", time);
}

/// The printed sum without neighbours, and the printed rate.
void record_printed_terms(ExperimentContext& context) {
  const auto without_neighbours = [](double v, double delta, bool as_printed) {
    const double sum =
        as_printed ? oracles::sum_4_3_as_printed({}, 0.0) : oracles::sum_4_3_corrected(v, {}, {});
    return oracles::section_4_3(v, sum, k, w, delta, 1.0);
  };
  context.record("isolated/shape-2/printed_at_w", without_neighbours(w, 2.0, true));
  context.record("isolated/shape-2/printed_at_2w", without_neighbours(2.0 * w, 2.0, true));
  context.record("isolated/shape-2/meant_at_w", std::abs(without_neighbours(w, 2.0, false)));
  for (const double shape : {0.5, 1.0}) {
    const std::string name = fmt::format("isolated/shape-{}", shape);
    context.record(name + "/printed_is_finite",
                   std::int64_t{std::isfinite(without_neighbours(1.0, shape, true))});
    context.record(name + "/meant_is_finite",
                   std::int64_t{std::isfinite(without_neighbours(1.0, shape, false))});
  }
  context.record("free-rate/printed", k / (1.0 - 2.0), "per time");
  context.record("free-rate/vanishing_plant", without_neighbours(1e-12, 2.0, false) / 1e-12,
                 "per time");
}

/// The bracket of the law for delta = 2 and a neighbour of size 1 that covers half a square metre
/// of a plant of one.
void record_units(ExperimentContext& context) {
  const auto bracket = [](double share) {
    return 1.0 - oracles::sum_4_3_as_printed({1.0}, share) / w;
  };
  context.record("units/square_metres", bracket(0.5));
  context.record("units/square_centimetres", bracket(0.5e4));
  context.record("units/share_in_square_metres", bracket(0.5 / 1.0));
  context.record("units/share_in_square_centimetres", bracket(0.5e4 / 1e4));
}

/// Two neighbours, of which only the first overlaps the plant; then they swap their sizes.
void record_index(ExperimentContext& context) {
  for (const auto& [name, near, far] :
       {std::tuple{"small-neighbour", 1.0, 4.0}, std::tuple{"large-neighbour", 4.0, 1.0}}) {
    context.record(fmt::format("index/{}/printed", name),
                   oracles::sum_4_3_as_printed({near, far}, 0.5));
    context.record(fmt::format("index/{}/meant", name),
                   oracles::sum_4_3_corrected(0.0, {near, far}, {0.5, 0.0}));
  }
}

/// The growth law with (4.3) and (4.4), p = 1, as printed and as meant.
void draw_printed_law(ExperimentContext& context) {
  std::vector<PlotPanel> panels;
  for (const bool as_printed : {true, false}) {
    PlotCurve first{.name = "plant 1", .x = {}, .y = {}},
        second{.name = "plant 2", .x = {}, .y = {}};
    auto v = start;
    for (int time = 0; time <= 100; ++time) {
      first.x.push_back(time);
      second.x.push_back(time);
      first.y.push_back(v.v_1);
      second.y.push_back(v.v_2);
      v = oracles::run_4_3(v, k, w, 1.0, 1.0, 0.01, as_printed);
    }
    panels.push_back(
        {.curves =
             {first,
              second,
              {.name = "largest size w", .x = {0, 100}, .y = {w, w}, .style = PlotStyle::dotted}},
         .caption = as_printed ? "a) as printed" : "b) as meant",
         .x_label = "time",
         .y_label = "size",
         .y_range = AxisRange{0, 20}});
  }
  add_plot(
      context, "growth-law-4.3",
      {.title = "The growth law of 4.3 for two plants, as printed and as meant",
       .description = "Size of two plants over time, plant 1 the smaller one at first, and the "
                      "largest size w as a dotted line. As printed both grow alike and to "
                      "twice w; as meant plant 2 nears w and plant 1 shrinks.",
       .panels = panels});
}

void run(ExperimentContext& context) {
  record_branches(context);
  record_printed_law(context);
  record_printed_terms(context);
  record_units(context);
  record_index(context);
  draw_printed_law(context);
}

}  // namespace

extern const ExperimentDescriptor printed_growth_law;
constinit const ExperimentDescriptor printed_growth_law{
    .id = "alsweis/printed-growth-law",
    .question = "Does the growth law for several plants, as printed, do what the text says?",
    .source = "[Alsweis] sec. 4.3 with (4.3) and (4.4)",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
