// SPDX-License-Identifier: MIT
// Sec. 4.2.1, 8.6, listing 9.17: the chance to grow by one factor, and by all.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/oracles/lesser2019_growth.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

double chance(double available, double needed, Tolerance tolerance = Tolerance::triangle) {
  return corrected_site_model()->chance(available, needed, tolerance);
}

void record_triangle(ExperimentContext& context) {
  const double needed = appletree().energy_demand.value();
  const auto record = [&](const char* name, double available) {
    context.record(fmt::format("triangle/{}", name), chance(available, needed));
  };
  record("nothing", 0.0);
  record("half", 0.5 * needed);
  record("need", needed);
  record("one-and-a-half", 1.5 * needed);
  record("twice", 2.0 * needed);
  record("three-times", 3.0 * needed);
  record("819-of-2000", 819.0);
  record("900.9-of-2000", 900.9);
  double off = 0.0, steepest = 0.0;
  std::int64_t full = 0, positive = 0, rises_above = 0, falls_below = 0;
  for (int percent = 0; percent <= 300; ++percent) {
    const double share = percent / 100.0, here = chance(share, 1.0);
    off = std::max(off, std::abs(here - oracle::listing_9_17(1.0, share)));
    full += here == 1.0;
    positive += here > 0.0;
    if (percent == 0) continue;
    const double before = chance((percent - 1) / 100.0, 1.0);
    steepest = std::max(steepest, std::abs(here - before) * 100.0);
    (percent <= 100 ? falls_below : rises_above) += percent <= 100 ? here <= before : here > before;
  }
  context.record("triangle/off-the-listing", off);
  context.record("triangle/greatest-change-over-need", steepest);
  context.record("triangle/percents-with-the-greatest-chance", full, "percent");
  context.record("triangle/percents-with-some-chance", positive, "percent");
  context.record("triangle/does-not-rise-up-to-the-need", falls_below, "percent");
  context.record("triangle/rises-beyond-the-need", rises_above, "percent");
}

void record_zero_need(ExperimentContext& context) {
  context.record("zero-need/of-nothing", chance(0.0, 0.0));
  context.record("zero-need/of-something", chance(1.0, 0.0));
  context.record("zero-need/printed/of-nothing-is-undefined",
                 std::int64_t{std::isnan(oracle::listing_9_17(0.0, 0.0))});
  context.record("zero-need/printed/of-something", oracle::listing_9_17(0.0, 1.0));
}

/// Sec. 8.6: the least of four chances. What the law of the minimum asks of it.
void record_minimum(ExperimentContext& context) {
  CounterStream stream(context.seed(), 70);
  std::int64_t above_one = 0, order_matters = 0, falls = 0, is_none = 0, trials = 1000;
  for (std::int64_t trial = 0; trial < trials; ++trial) {
    std::vector<double> chances(4);
    for (double& c : chances) c = stream.next_unit();
    const double least = oracle::least_chance(chances);
    is_none += std::find(chances.begin(), chances.end(), least) == chances.end();
    for (const double c : chances) above_one += least > c;
    std::vector<double> turned(chances.rbegin(), chances.rend());
    order_matters += oracle::least_chance(turned) != least;
    for (double& c : chances) {
      const double before = c;
      c = std::min(1.0, c + 0.3);
      falls += oracle::least_chance(chances) < least;
      c = before;
    }
  }
  context.record("minimum/trials", trials, "trials");
  context.record("minimum/above-a-factor", above_one, "factors");
  context.record("minimum/no-factor", is_none, "trials");
  context.record("minimum/order-matters", order_matters, "trials");
  context.record("minimum/falls-when-a-factor-rises", falls, "factors");
  // Light, depth and soil at their best, a tenth of the water.
  context.record("minimum/a-tenth-of-the-water",
                 oracle::least_chance({1.0, chance(0.1, 1.0), 1.0, 1.0}));
}

/// Sec. 8.6 lets the chance fall in soil that is deeper than needed.
void record_depth_rules(ExperimentContext& context) {
  for (const PlantSpecies& species : {appletree(), shrub(), moss()}) {
    const auto record = [&](const char* rule, Tolerance tolerance) {
      context.record(fmt::format("depth-rules/{}/{}", species.name, rule),
                     chance(1.5, species.soil_depth.value(), tolerance));
    };
    record("triangle", Tolerance::triangle);
    record("saturating", Tolerance::saturating);
    record("threshold", Tolerance::threshold);
  }
  std::int64_t deeper_is_worse = 0;
  for (int depth = 1; depth <= 150; ++depth)
    deeper_is_worse += chance(depth, 80.0) < chance(depth - 1, 80.0);
  context.record("depth-rules/triangle/deeper-is-worse", deeper_is_worse, "cm");
}

void run(ExperimentContext& context) {
  record_triangle(context);
  record_zero_need(context);
  record_minimum(context);
  record_depth_rules(context);
}

}  // namespace

extern const ExperimentDescriptor growth_chance;
constinit const ExperimentDescriptor growth_chance{
    .id = "lesser2019/growth-chance",
    .question = "How likely does a plant grow on what is there?",
    .source = "[Lesser2019] sec. 4.2.1, 8.6, 9.2.9, listing 9.17",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
