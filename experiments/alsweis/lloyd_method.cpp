// SPDX-License-Identifier: MIT
// Points that move to the centroids of their Voronoi cells, twenty times: figure 2.3, and the
// regular pattern of figure 2.4.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/point_pattern/dart_throwing.hpp"
#include "core/point_pattern/hopkins.hpp"
#include "core/point_pattern/lloyd.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/pattern_svg.hpp"
#include "core/point_pattern/voronoi.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr int steps = 20;
constexpr int starts = 30;

const Window& torus() {
  static const Window unit = Window::torus({{0, 0}, {1, 1}});
  return unit;
}

/// One start, step by step.
struct Run {
  std::array<double, steps + 1> energy{};  ///< times the number of points; after k steps
  double hopkins = 0.0;
  double spacing = 0.0;  ///< least distance, over that of the triangular lattice
  std::vector<Point2> points;
};

Run lloyd_run(std::size_t count, std::uint64_t seed, std::uint64_t start) {
  Run run;
  run.points = random_pattern(torus(), count, seed, start);
  for (int k = 0; k <= steps; ++k) {
    const LloydStep step = lloyd_step(run.points, torus());
    run.energy[static_cast<std::size_t>(k)] = static_cast<double>(count) * step.energy;
    if (k < steps) run.points = step.points;
  }
  run.hopkins = hopkins_exact(run.points, torus()).mean_ratio;
  const auto distances = nearest_distances(run.points, torus());
  run.spacing = *std::min_element(distances.begin(), distances.end()) /
                std::sqrt(2.0 / (std::sqrt(3.0) * static_cast<double>(count)));
  return run;
}

void record_mean(ExperimentContext& context, const std::string& name,
                 const RunningMoments& values) {
  const auto record = [&](const char* what, double value) {
    context.record({.experiment = {},
                    .measurement = name + what,
                    .value = value,
                    .sample_size = values.count(),
                    .seed = context.seed()});
  };
  record("/mean", values.mean());
  record("/standard_error", values.standard_error());
  record("/least", values.least());
  record("/largest", values.largest());
}

void record_runs(ExperimentContext& context, std::size_t count) {
  RunningMoments hopkins, spacing, rise;
  std::array<RunningMoments, steps + 1> energy;
  for (std::uint64_t s = 0; s < starts; ++s) {
    context.progress(fmt::format("{} points, start {} of {}", count, s + 1, starts));
    const Run run = lloyd_run(count, context.seed(), s);
    hopkins.add(run.hopkins);
    spacing.add(run.spacing);
    for (std::size_t k = 0; k <= steps; ++k) energy[k].add(run.energy[k]);
    for (std::size_t k = 1; k <= steps; ++k) rise.add(run.energy[k] / run.energy[k - 1] - 1.0);
  }
  const std::string name = fmt::format("points-{}", count);
  record_mean(context, name + "/hopkins", hopkins);
  record_mean(context, name + "/least_distance", spacing);
  for (const std::size_t k : {0u, 1u, 4u, 9u, 19u, 20u})
    record_mean(context, fmt::format("{}/energy.{}", name, k), energy[k]);
  context.record(name + "/largest_rise", rise.largest());
}

/// What else might stand behind "H = 0.4": darts thrown until none fits.
void record_darts(ExperimentContext& context) {
  RunningMoments hopkins;
  for (std::uint64_t s = 0; s < starts; ++s) {
    CounterStream stream(context.seed(), 1000 + s);
    const double distance = std::sqrt(0.6966 / 200.0);
    hopkins.add(
        hopkins_exact(dart_points(torus(), distance, until_saturated, stream), torus()).mean_ratio);
  }
  record_mean(context, "saturated-darts/hopkins", hopkins);
}

/// Figure 2.3: start with its cells, the ways of all points, the result.
void draw_figure(ExperimentContext& context) {
  constexpr std::size_t count = 100;
  std::vector<Point2> points = random_pattern(torus(), count, context.seed(), 0);
  PatternPanel start{.points = points,
                     .cells = voronoi_cells(points, torus()),
                     .caption = "a) random points, their cells"};
  std::vector<std::vector<Point2>> ways;
  for (const Point2& p : points) ways.push_back({p});
  for (int k = 0; k < steps; ++k) {
    const std::vector<Point2> next = lloyd_step(points, torus()).points;
    for (std::size_t i = 0; i < count; ++i)
      ways[i].push_back(ways[i].back() + torus().difference(points[i], next[i]));
    points = next;
  }
  PatternPanel moves{.points = {}, .ways = ways, .caption = "b) ways of the points"};
  PatternPanel end{.points = points,
                   .cells = voronoi_cells(points, torus()),
                   .caption = "c) after 20 iterations"};
  context.artifact("figure-2.3.svg",
                   pattern_svg({start, moves, end}, torus(),
                               "Figure 2.3: the generalised Lloyd method on a torus, 100 points"));
}

void run(ExperimentContext& context) {
  record_runs(context, 200);
  record_runs(context, 50);
  record_darts(context);
  draw_figure(context);
}

}  // namespace

extern const ExperimentDescriptor lloyd_method;
constinit const ExperimentDescriptor lloyd_method{
    .id = "alsweis/lloyd-method",
    .question = "How regular do points become that move to the centroids of their cells?",
    .source = "[Alsweis] sec. 2.4.1, figures 2.3 and 2.4",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
