// SPDX-License-Identifier: MIT
// What the Hopkins index says of random, clustered and regular patterns, and whether tests with it
// hold their level.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "core/point_pattern/cluster_patterns.hpp"
#include "core/point_pattern/hopkins.hpp"
#include "core/point_pattern/hopkins_null.hpp"
#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/lloyd.hpp"
#include "core/point_pattern/monte_carlo.hpp"
#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/pattern_svg.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/f_distribution.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_hopkins.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;

const Window& torus() {
  static const Window unit = Window::torus({{0, 0}, {1, 1}});
  return unit;
}

const Window& square() {
  static const Window unit = Window::rectangle({{0, 0}, {1, 1}});
  return unit;
}

/// Seeds of different questions.
enum SeedOffset : std::uint64_t { patterns = 0, places = 100, clusters = 200, level_peers = 300 };

int patterns_of(Tier tier) {
  return tier == Tier::full ? 10'000 : tier == Tier::quick ? 3'000 : 1'000;
}

void record(ExperimentContext& context, const std::string& name, double value,
            std::int64_t sample) {
  context.record({.experiment = {},
                  .measurement = name,
                  .value = value,
                  .sample_size = sample,
                  .seed = context.seed()});
}

std::vector<oracles::Plant> plants(const std::vector<Point2>& points) {
  std::vector<oracles::Plant> all;
  for (const Point2& p : points) all.push_back({p.x, p.y});
  return all;
}

/// The printed denominator lets a plant be its own neighbour; the corrected one is core's.
void record_printed(ExperimentContext& context) {
  const std::vector<Point2> points = random_pattern(square(), 200, context.seed(), 0);
  CounterStream stream(context.seed(), places);
  std::vector<Point2> random_places;
  for (int i = 0; i < 500; ++i) random_places.push_back(square().random_point(stream));
  const double numerator = oracles::equation_2_8_numerator(plants(random_places), plants(points));
  const double corrected = oracles::equation_2_8_denominator(plants(points), false);
  CounterStream again(context.seed(), places);
  const double ours = hopkins_sampled(points, square(), 500, again).mean_ratio;
  context.record("printed/denominator", oracles::equation_2_8_denominator(plants(points), true));
  context.record("corrected/denominator", corrected);
  context.record("corrected/difference_from_core", std::abs(ours / (numerator / corrected) - 1.0));
}

void record_random(ExperimentContext& context, const Window& window, std::size_t count) {
  const int runs = std::max(300, patterns_of(context.tier()) * 25 / static_cast<int>(count));
  RunningMoments exact, sampled;
  for (int k = 0; k < runs; ++k) {
    if (k % 100 == 0) context.progress(fmt::format("{} random points: {} of {}", count, k, runs));
    const auto index = static_cast<std::uint64_t>(k);
    const auto points = random_pattern(window, count, context.seed() + patterns + count, index);
    CounterStream stream(context.seed() + places + count, index);
    exact.add(hopkins_exact(points, window).mean_ratio);
    sampled.add(hopkins_sampled(points, window, count, stream).mean_ratio);
  }
  const std::string name = fmt::format("random/{}-{}", name_of(window.kind()), count);
  // The claim is H = 1 up to what finite numbers add: how much is left of the bound.
  const auto excess = [&](const RunningMoments& m) {
    return std::abs(m.mean() - 1.0) / (4.0 * m.standard_error() + 0.5 / static_cast<double>(count));
  };
  record(context, name + "/exact/mean", exact.mean(), exact.count());
  record(context, name + "/exact/deviation", exact.deviation(), exact.count());
  record(context, name + "/exact/share_of_bound", excess(exact), exact.count());
  record(context, name + "/sampled/mean", sampled.mean(), sampled.count());
  record(context, name + "/sampled/deviation", sampled.deviation(), sampled.count());
  record(context, name + "/sampled/share_of_bound", excess(sampled), sampled.count());
}

/// Ratio of the expectations of numerator and denominator, by integration.
void record_expectations(ExperimentContext& context) {
  double worst = 0.0;
  for (const std::size_t n : {2u, 3u, 4u, 5u, 10u, 25u, 100u, 400u}) {
    const double ratio =
        expected_nearest_distance(torus(), n) / expected_nearest_distance(torus(), n - 1);
    context.record(fmt::format("expectations/torus-{}", n), ratio);
    const double limit = 2.0 * static_cast<double>(n) / (2.0 * static_cast<double>(n) + 1.0);
    if (n >= 10) worst = std::max(worst, std::abs(ratio - limit));
  }
  context.record("expectations/difference_from_2n_over_2n_plus_1", worst);
}

void record_lattices(ExperimentContext& context) {
  const Rectangle even{{0, 0}, {20, 20}};
  const Rectangle wide{{0, 0}, {12, 14 * std::sqrt(3.0) / 2.0}};
  context.record("lattice/square",
                 hopkins_exact(square_lattice(even, 20, 20), Window::torus(even)).mean_ratio);
  context.record("lattice/triangular",
                 hopkins_exact(triangular_lattice(wide, 12, 14), Window::torus(wide)).mean_ratio);
}

/// The dissertation's reason for clusters: seeds that fall near their parents.
std::vector<Point2> thomas(const ExperimentContext& context, double parents, double seeds,
                           double sigma, std::uint64_t index) {
  CounterStream stream(context.seed() + clusters, index);
  return thomas_points(torus(), {{parents, NumberLaw::fixed, seeds, NumberLaw::fixed}, sigma},
                       stream);
}

RunningMoments thomas_hopkins(const ExperimentContext& context, double parents, double seeds,
                              double sigma, int runs) {
  RunningMoments h;
  for (int k = 0; k < runs; ++k)
    h.add(hopkins_exact(thomas(context, parents, seeds, sigma, static_cast<std::uint64_t>(k)),
                        torus())
              .mean_ratio);
  return h;
}

void record_clusters(ExperimentContext& context) {
  struct Set {
    const char* name;
    double parents, seeds, sigma;
  };
  const int runs = patterns_of(context.tier()) / 10;
  for (const Set& s : {Set{"20-20-0.05", 20, 20, 0.05}, Set{"20-20-0.03", 20, 20, 0.03},
                       Set{"40-10-0.03", 40, 10, 0.03}}) {
    context.progress(std::string("clusters ") + s.name);
    const RunningMoments h = thomas_hopkins(context, s.parents, s.seeds, s.sigma, runs);
    record(context, std::string("clusters/") + s.name + "/mean", h.mean(), h.count());
    record(context, std::string("clusters/") + s.name + "/deviation", h.deviation(), h.count());
    record(context, std::string("clusters/") + s.name + "/least", h.least(), h.count());
    const RunningMoments twenty = thomas_hopkins(context, s.parents, s.seeds, s.sigma, 20);
    record(context, std::string("clusters/") + s.name + "/least_of_20", twenty.least(), 20);
  }
}

constexpr int figure_patterns = 400;

/// The spread at which 20 parents with 20 seeds each have H = 2.4 on average.
double sigma_of_figure(ExperimentContext& context) {
  double low = 0.02, high = 0.1;
  for (int k = 0; k < 10; ++k) {  // to a tenth of a percent of H
    const double middle = 0.5 * (low + high);
    (thomas_hopkins(context, 20, 20, middle, figure_patterns).mean() > 2.4 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void draw_figure(ExperimentContext& context) {
  const double sigma = sigma_of_figure(context);
  // Other patterns than those it was found with.
  RunningMoments h;
  for (std::uint64_t k = 0; k < figure_patterns; ++k)
    h.add(hopkins_exact(thomas(context, 20, 20, sigma, 1'000'000 + k), torus()).mean_ratio);
  record(context, "figure-2.4b/sigma", sigma, h.count());
  record(context, "figure-2.4b/hopkins", h.mean(), h.count());
  std::vector<Point2> best;
  double nearest = INFINITY;
  for (std::uint64_t k = 0; k < 100; ++k) {
    std::vector<Point2> points = thomas(context, 20, 20, sigma, k);
    const double off = std::abs(hopkins_exact(points, torus()).mean_ratio - 2.4);
    if (off < nearest) {
      nearest = off;
      best = std::move(points);
    }
  }
  const auto even = lloyd_points(random_pattern(torus(), 200, context.seed(), 0), torus(), 20);
  const auto caption = [](const char* letter, const std::vector<Point2>& points,
                          const char* published) {
    return fmt::format("{}) H = {:.2f} of ours, {} published", letter,
                       hopkins_exact(points, torus()).mean_ratio, published);
  };
  context.artifact("figure-2.4.svg",
                   pattern_svg({{.points = even, .caption = caption("a", even, "0.4")},
                                {.points = best, .caption = caption("b", best, "2.4")}},
                               torus(), "Figure 2.4: an even and a clustered pattern of ours"));
}

/// The same pattern, larger, smaller and in another order.
void record_invariance(ExperimentContext& context) {
  double worst = 0.0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    std::vector<Point2> points = random_pattern(square(), 150, context.seed(), k);
    const double h = hopkins_exact(points, square()).mean_ratio;
    for (const double factor : {1e-6, 0.3, 1e6}) {
      std::vector<Point2> scaled(points.rbegin(), points.rend());
      for (Point2& p : scaled) p = factor * p;
      const Window window = Window::rectangle({{0, 0}, {factor, factor}});
      worst = std::max(worst, std::abs(hopkins_exact(scaled, window).mean_ratio / h - 1.0));
    }
  }
  context.record("invariance/largest_change", worst);
}

/// How often the test at 5 % finds what is there, in patterns of 100 points: clusters so loose that
/// they touch, and one point in each cell of a lattice.
void record_power(ExperimentContext& context) {
  constexpr std::size_t count = 100;
  const int runs = patterns_of(context.tier()) / 5;
  const HopkinsNull null =
      hopkins_null(torus(), count, {.simulations = 999, .seed = context.seed() + level_peers});
  const auto share_found = [&](const auto& pattern) {
    int found = 0;
    for (int k = 0; k < runs; ++k)
      found +=
          rank_p_value(hopkins_exact(pattern(static_cast<std::uint64_t>(k)), torus()).mean_ratio,
                       null.mean_ratio, Tail::both) <= 0.05;
    return static_cast<double>(found) / runs;
  };
  for (const double sigma : {0.03, 0.06, 0.12})
    record(context, fmt::format("power/clusters-20-5-{}", sigma),
           share_found([&](std::uint64_t k) { return thomas(context, 20, 5, sigma, k); }), runs);
  record(context, "power/jittered-lattice", share_found([&](std::uint64_t k) {
           CounterStream stream(context.seed() + places, k);
           return jittered_lattice({{0, 0}, {1, 1}}, 10, 10, stream);
         }),
         runs);
}

/// How often tests at 5 % call random patterns of 50 points something else.
void record_levels(ExperimentContext& context) {
  constexpr std::size_t count = 50;
  const int runs = patterns_of(context.tier());
  const double low = f_quantile(0.025, {2.0 * count, 2.0 * count});
  const double high = f_quantile(0.975, {2.0 * count, 2.0 * count});
  int by_f = 0, by_simulation = 0;
  for (int k = 0; k < runs; ++k) {
    if (k % 100 == 0) context.progress(fmt::format("levels: {} of {}", k, runs));
    const auto index = static_cast<std::uint64_t>(k);
    const auto points = random_pattern(square(), count, context.seed() + patterns, index);
    CounterStream stream(context.seed() + places, index);
    const double a = 1.0 / hopkins_sampled(points, square(), count, stream).squared_ratio;
    by_f += a < low || a > high;
    // 39 peers of its own: the rank is exact at 5 %.
    const HopkinsNull null = hopkins_null(
        square(), count,
        {.simulations = 39, .seed = context.seed() + level_peers + 1000 * (index + 1)});
    by_simulation += rank_p_value(hopkins_exact(points, square()).mean_ratio, null.mean_ratio,
                                  Tail::both) <= 0.05;
  }
  record(context, "level/f_test", static_cast<double>(by_f) / runs, runs);
  record(context, "level/simulation", static_cast<double>(by_simulation) / runs, runs);
}

void run(ExperimentContext& context) {
  record_printed(context);
  for (const std::size_t count : {25u, 100u, 400u}) {
    record_random(context, torus(), count);
    record_random(context, square(), count);
  }
  record_expectations(context);
  record_lattices(context);
  record_clusters(context);
  record_invariance(context);
  record_levels(context);
  record_power(context);
  draw_figure(context);
}

}  // namespace

extern const ExperimentDescriptor hopkins_index;
constinit const ExperimentDescriptor hopkins_index{
    .id = "alsweis/hopkins-index",
    .question = "Does the Hopkins index tell random, clustered and regular patterns apart?",
    .source = "[Alsweis] (2.8), figure 2.4",
    .seconds = {5, 12, 40},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
