// SPDX-License-Identifier: MIT
// Laws of many discs at once: what pairs must add up to, and why pairs are not enough.
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/coverage.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

struct Scene {
  std::vector<double> x, y, radius;
  Ground ground;

  Discs discs() const { return {x, y, radius}; }
};

/// Independent uniform plants on a torus; radii from 0.4 to 1.4, in no order of the places.
Scene random_scene(std::size_t count, std::uint64_t seed) {
  Scene scene;
  const double side = std::sqrt(static_cast<double>(count));
  scene.ground.torus = Rectangle{{0, 0}, {side, side}};
  for (std::size_t i = 0; i < count; ++i) {
    scene.x.push_back(side * random_unit(seed, 0, i));
    scene.y.push_back(side * random_unit(seed, 1, i));
    scene.radius.push_back(0.4 + random_unit(seed, 2, i));
  }
  return scene;
}

double disc_area(double r) {
  return std::numbers::pi * r * r;
}

/// Two plants share the product of their areas over the ground's on average, wherever they are. All
/// pairs add up to half of ((sum of areas)^2 - sum of squared areas) over the ground.
void record_pair_sum(ExperimentContext& context, const std::string& size, std::size_t count,
                     int scenes) {
  RunningMoments ratio;
  for (int s = 0; s < scenes; ++s) {
    context.progress(fmt::format("{} plants, scene {} of {}", count, s + 1, scenes));
    const Scene scene = random_scene(count, context.seed() + static_cast<std::uint64_t>(s));
    OverlapPairs pairs;
    overlap_engine_named("layered_grid")
        .create()
        ->find(scene.discs(), scene.ground, {.threads = context.threads()}, pairs);
    double found = 0.0, areas = 0.0, squared_areas = 0.0;
    for (const double area : pairs.area()) found += area;
    for (const double r : scene.radius) {
      areas += disc_area(r);
      squared_areas += disc_area(r) * disc_area(r);
    }
    ratio.add(found * scene.ground.torus->area() / (0.5 * (areas * areas - squared_areas)));
  }
  const std::string name = "pairs/" + size;
  const auto record = [&](const char* what, double value) {
    context.record({.experiment = {},
                    .measurement = name + what,
                    .value = value,
                    .sample_size = scenes,
                    .seed = context.seed()});
  };
  record("/plants", static_cast<double>(count));
  record("/over_expectation", ratio.mean());
  record("/standard_error", ratio.standard_error());
  record("/deviation", (ratio.mean() - 1.0) / ratio.standard_error());
}

/// How many plants the sum over pairs says to be covered by more than themselves.
void record_multiplicity(ExperimentContext& context) {
  constexpr std::size_t count = 10'000;
  const Scene scene = random_scene(count, context.seed() + 500);
  OverlapPairs pairs;
  overlap_engine_named("layered_grid").create()->find(scene.discs(), scene.ground, {}, pairs);
  pairs.sort_and_merge(count);
  std::vector<double> overlap(count, 0.0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
    for (const DiscIndex i : {pairs.first()[p], pairs.second()[p]})
      overlap[static_cast<std::size_t>(i)] += pairs.area()[p];
  const Coverage ground = coverage(scene.discs(), scene.ground, {}, context.threads());
  double beyond = 0.0, excess = 0.0, bare = 1.0, areas = 0.0, weighted = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double area = disc_area(scene.radius[i]);
    beyond += overlap[i] > area;
    excess = std::max(excess, ground.covered[i] / area - 1.0);
    bare *= 1.0 - area / scene.ground.torus->area();
    areas += area;
  }
  for (std::size_t k = 1; k < ground.by_times.size(); ++k)
    weighted += static_cast<double>(k) * ground.by_times[k];
  context.record("multiplicity/share_of_pair_sums_beyond_the_plant", beyond / count);
  context.record("multiplicity/largest_excess_of_covered_area", excess);
  context.record("multiplicity/sum_rule_error", std::abs(weighted / areas - 1.0));
  context.record("multiplicity/bare_share", ground.by_times[0] / scene.ground.torus->area());
  context.record("multiplicity/expected_bare_share", bare);
}

void run(ExperimentContext& context) {
  const bool full = context.tier() == Tier::full;
  record_pair_sum(context, "small", 1'000, 200);
  record_pair_sum(context, "large", full ? 1'000'000 : 100'000, 20);
  record_multiplicity(context);
}

}  // namespace

extern const ExperimentDescriptor overlap_scenes;
constinit const ExperimentDescriptor overlap_scenes{
    .id = "alsweis/overlap-scenes",
    .question = "Do the overlaps of many plants add up to what they must?",
    .source = "[Alsweis] appendix A, chapter 4",
    .seconds = {1, 1, 10},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
