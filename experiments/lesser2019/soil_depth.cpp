// SPDX-License-Identifier: MIT
// Sec. 8.4, listing 9.15: how deep the soil is on a slope.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/terrain/relief.hpp"
#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/oracle_maps.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_relief.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

constexpr double deepest = 150.0;  // cm, listing 9.5

double depth(double angle) {
  return in_centimetres(corrected_site_model()->soil_depth(angle, centimetres(deepest)));
}

oracle::Normal tilted(double degrees) {
  const double angle = degrees * (std::numbers::pi / 180.0);
  return {std::sin(angle), 0.0, std::cos(angle)};
}

/// What listing 9.15 makes of the dot product itself.
double depth_by_dot(double angle) {
  return oracle::listing_9_15(oracle::dot_with_vertical(tilted(angle)), deepest);
}

void record_angles(ExperimentContext& context) {
  std::int64_t not_less = 0, not_less_by_dot = 0;
  for (int angle = 1; angle <= 90; ++angle) {
    not_less += !(depth(angle) < depth(angle - 1));
    not_less_by_dot += !(depth_by_dot(angle) < depth_by_dot(angle - 1));
  }
  for (const int angle : {0, 45, 60, 90}) {
    context.record(fmt::format("angle-{}", angle), depth(angle), "cm");
    context.record(fmt::format("angle-{}/by-the-listing", angle),
                   oracle::listing_9_15(oracle::angle_to_vertical(tilted(angle)), deepest), "cm");
  }
  context.record("steps", std::int64_t{90}, "steps");
  context.record("steps/not-less", not_less, "steps");
  context.record("steps/not-less-by-dot", not_less_by_dot, "steps");
}

void record_dot(ExperimentContext& context) {
  context.record("dot/of-60", oracle::dot_with_vertical(tilted(60.0)));
  context.record("dot/angle-of-60", oracle::angle_to_vertical(tilted(60.0)), "degrees");
  context.record("dot/depth-on-level-ground", depth_by_dot(0.0), "cm");
  context.record("dot/depth-on-a-wall", depth_by_dot(90.0), "cm");
}

/// A needle of 1000 m: steeper than anything, and level to an estimator that looks at the
/// neighbours only.
void record_needle(ExperimentContext& context) {
  const HeightField field = square_field(
      5, thesis_cell, [](int column, int row) { return column == 2 && row == 2 ? 1000.0 : 0.0; });
  for (const auto& [name, estimator] :
       {std::pair("six-faces", SurfaceEstimator::six_faces),
        std::pair("six-faces-weighing-the-same", SurfaceEstimator::unit_faces),
        std::pair("sobel", SurfaceEstimator::sobel)})
    context.record(fmt::format("needle/{}", name),
                   depth(slope_degrees(surface_gradient(field, 2, 2, estimator))), "cm");
  const double steepest = oracle::steepest_edge(oracle_map(field), 2, 2);
  context.record("needle/steepest-edge/slope", steepest, "degrees");
  context.record("needle/steepest-edge", depth(steepest), "cm");
}

void run(ExperimentContext& context) {
  record_angles(context);
  record_dot(context);
  record_needle(context);
}

}  // namespace

extern const ExperimentDescriptor soil_depth;
constinit const ExperimentDescriptor soil_depth{
    .id = "lesser2019/soil-depth",
    .question = "How deep is the soil on a slope?",
    .source = "[Lesser2019] sec. 8.4, 9.2.7, listing 9.15",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
