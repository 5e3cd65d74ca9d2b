// SPDX-License-Identifier: MIT
// How many seeds a plant bears and how far they fall: (4.6) as printed, and three readings of it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/point_pattern/pattern_svg.hpp"
#include "core/population/seed_dispersal.hpp"
#include "core/population/seed_production.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_population.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::population;

constexpr double pi = std::numbers::pi;

/// Of f over [0, high], by Simpson's rule.
template <class Function>
double integral(double high, const Function& f) {
  constexpr int intervals = 100'000;
  const double h = high / intervals;
  double sum = f(0.0) + f(high);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 0 ? 2.0 : 4.0) * f(i * h);
  return sum * h / 3.0;
}

/// What (4.6) is as printed: whether its logarithm bends as that of a Gaussian does, and its
/// integrals.
void record_printed(ExperimentContext& context) {
  for (const double lambda : {1.0, 5.0}) {
    const auto p = [lambda](double r) { return oracles::equation_4_6_as_printed(r, lambda); };
    // Second difference of the logarithm, times lambda^2: -1 for the Gaussian of that deviation.
    const double h = 0.1 * lambda;
    double bend = 0.0;
    for (int i = 1; i < 100; ++i)
      bend = std::max(bend, std::abs(std::log(p((i + 1) * h)) - 2.0 * std::log(p(i * h)) +
                                     std::log(p((i - 1) * h))) /
                                0.01);
    const std::string name = fmt::format("printed/lambda-{}", lambda);
    context.record(name + "/bend_of_logarithm", bend);
    context.record(name + "/integral_over_distances", integral(80.0 * lambda, p), "length");
    context.record(name + "/integral_over_plane",
                   integral(80.0 * lambda, [&](double r) { return 2.0 * pi * r * p(r); }),
                   "length^2");
    context.record(name + "/corrected_integral_over_distances",
                   integral(80.0 * lambda,
                            [&](double r) { return oracles::equation_4_6_corrected(r, lambda); }));
  }
  const SeedDispersal ours{.scale = 5.0};
  double off = 0.0;
  for (int i = 0; i <= 100; ++i)
    off = std::max(off, std::abs(ours.distance_density(0.5 * i) /
                                     oracles::equation_4_6_corrected(0.5 * i, 5.0) -
                                 1.0));
  context.record("agreement/largest_difference", off);
}

int draws_of(Tier tier) {
  return tier == Tier::full ? 4'000'000 : tier == Tier::quick ? 400'000 : 100'000;
}

/// Standard deviation of distances with scale 1, from the law.
double deviation_of(DispersalLaw law) {
  switch (law) {
    case DispersalLaw::radial_exponential:
      return 1.0;
    case DispersalLaw::planar_exponential:
      return std::numbers::sqrt2;
    case DispersalLaw::gaussian:
      return std::sqrt(2.0 - 0.5 * pi);
  }
  return 0.0;
}

/// Distances of many seeds, lambda = 1, beside the law they were drawn from.
void record_law(ExperimentContext& context, DispersalLaw law) {
  const SeedDispersal dispersal{law, 1.0};
  const int draws = draws_of(context.tier());
  CounterStream stream(context.seed(), static_cast<std::uint64_t>(law));
  RunningMoments moments;
  std::vector<double> places, turns;
  for (int i = 0; i < draws; ++i) {
    const Point2 seed = dispersal.draw(stream);
    moments.add(norm(seed));
    places.push_back(dispersal.distance_distribution(norm(seed)));
    turns.push_back(std::atan2(seed.y, seed.x) / (2.0 * pi) + 0.5);
  }
  const auto record = [&](const char* what, double value, const char* unit) {
    context.record({.experiment = {},
                    .measurement = fmt::format("laws/{}/{}", name_of(law), what),
                    .value = value,
                    .unit = unit,
                    .sample_size = draws,
                    .seed = context.seed()});
  };
  record("mean", moments.mean(), "lambda");
  record("mean_deviation",
         (moments.mean() - dispersal.mean_distance()) * std::sqrt(draws) / deviation_of(law),
         "standard errors");
  record("ks_p_value", kolmogorov_uniformity_p_value(places), "1");
  record("ks_p_value_of_directions", kolmogorov_uniformity_p_value(turns), "1");
  const std::string name = fmt::format("laws/{}/", name_of(law));
  context.record(name + "exact_mean", dispersal.mean_distance(), "lambda");
  context.record(name + "exact_median", dispersal.median_distance(), "lambda");
  context.record(name + "exact_95_percent", dispersal.distance_quantile(0.95), "lambda");
}

/// Neither the threshold nor the slope is published: a woody plant, radius in metres.
void record_production(ExperimentContext& context) {
  constexpr SeedProduction woody{.threshold = 0.25, .seeds_per_size = 20.0, .largest_size = 0.5};
  constexpr double step = 0.001;
  double below = 0.0, bend = 0.0, beyond = 0.0, jump = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double size = i * step, seeds = woody.expected_seeds(size);
    const double rise = woody.expected_seeds(size + step) - seeds;
    jump = std::max(jump, std::abs(rise));
    if (size < 0.25) below = std::max(below, seeds);
    if (i >= 250 && i < 500) bend = std::max(bend, std::abs(rise - 20.0 * step));
    if (size >= 0.5) beyond = std::max(beyond, std::abs(rise));
  }
  context.record("production/largest_below_threshold", below, "seeds");
  context.record("production/off_from_line", bend, "seeds");
  context.record("production/rise_beyond_largest_size", beyond, "seeds");
  context.record("production/largest_step_per_mm", jump, "seeds");
  context.record("production/at_threshold", woody.expected_seeds(0.25), "seeds");
  context.record("production/at_0.3_m", woody.expected_seeds(0.3), "seeds");
  context.record("production/at_0.5_m", woody.expected_seeds(0.5), "seeds");
  context.record("production/at_0.8_m", woody.expected_seeds(0.8), "seeds");
}

void draw_laws(ExperimentContext& context) {
  PlotPanel within{.caption = "seeds up to a distance",
                   .x_label = "distance / λ",
                   .y_label = "% of seeds",
                   .y_range = AxisRange{0.0, 100.0}};
  PlotPanel density{.caption = "seeds per area",
                    .x_label = "distance / λ",
                    .y_label = "share per λ²",
                    .log_y = true,
                    .y_range = AxisRange{1e-5, 10.0}};
  for (const DispersalLaw law : all_dispersal_laws) {
    const SeedDispersal dispersal{law, 1.0};
    PlotCurve share{.name = std::string(name_of(law))}, per_area{.name = std::string(name_of(law))};
    for (int i = 0; i <= 240; ++i) {
      const double r = i / 40.0;
      share.x.push_back(r);
      share.y.push_back(100.0 * dispersal.distance_distribution(r));
      if (i == 0) continue;  // infinite for the radial law
      per_area.x.push_back(r);
      per_area.y.push_back(dispersal.plane_density(r));
    }
    within.curves.push_back(share);
    density.curves.push_back(per_area);
  }
  add_plot(context, "dispersal-laws",
           {.title = "Three readings of the seed dispersal (4.6)",
            .description = "Seeds that fall within a distance, and seeds per area at it on a "
                           "logarithmic axis, both over the distance in units of λ.",
            .panels = {within, density}});
}

void draw_seeds(ExperimentContext& context) {
  std::vector<PatternPanel> panels;
  const Window window = Window::rectangle({{-5.0, -5.0}, {5.0, 5.0}});
  for (const DispersalLaw law : all_dispersal_laws) {
    CounterStream stream(context.seed(), 100 + static_cast<std::uint64_t>(law));
    PatternPanel panel{.points = {}, .caption = std::string(name_of(law))};
    for (int i = 0; i < 400; ++i) {
      const Point2 seed = SeedDispersal{law, 1.0}.draw(stream);
      if (window.contains(seed)) panel.points.push_back(seed);
    }
    panels.push_back(panel);
  }
  context.artifact("dispersed-seeds.svg",
                   pattern_svg(panels, window, "400 seeds of one plant, 10 λ across"));
}

void run(ExperimentContext& context) {
  record_printed(context);
  for (const DispersalLaw law : all_dispersal_laws) {
    context.progress(std::string(name_of(law)));
    record_law(context, law);
  }
  record_production(context);
  draw_laws(context);
  draw_seeds(context);
}

}  // namespace

extern const ExperimentDescriptor seed_dispersal;
constinit const ExperimentDescriptor seed_dispersal{
    .id = "alsweis/seed-dispersal",
    .question = "How far do seeds fall, and is the scale of the dispersal its mean?",
    .source = "[Alsweis] sec. 4.4, (4.6)",
    .seconds = {1, 1, 4},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
