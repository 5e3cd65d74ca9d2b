// SPDX-License-Identifier: MIT
// The circle that stands for a plant, and the distance of two: what appendix A builds on.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/competition/zone_laws.hpp"
#include "core/overlap/discs.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr int draws = 10'000;

void record_largest(ExperimentContext& context, const char* name, double value) {
  context.record({.experiment = {},
                  .measurement = name,
                  .value = value,
                  .sample_size = draws,
                  .seed = context.seed()});
}

/// The suite goes from radius to area only; the radius that the text gives for an area must lead
/// back to it. Areas from a millionth to a million.
void record_radii(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  double largest = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double area = std::pow(10.0, stream.next_between(-6, 6));
    const double radius = std::sqrt(area / std::numbers::pi);
    largest = std::max(largest, std::abs(disc_area(radius) - area) / area);
  }
  record_largest(context, "radius/largest_relative_error", largest);
}

/// Plants anywhere on a plot of 200 m, against the root of squares that the C library computes.
void record_distances(ExperimentContext& context) {
  CounterStream stream(context.seed(), 1);
  double largest = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x[] = {stream.next_between(0, 200), stream.next_between(0, 200)};
    const double y[] = {stream.next_between(0, 200), stream.next_between(0, 200)};
    const double radius[] = {1.0, 1.0};
    const double expected = std::hypot(x[0] - x[1], y[0] - y[1]);
    const double distance = center_distance({x, y, radius}, {}, 0, 1, {});
    largest = std::max(largest, std::abs(distance - expected) / expected);
  }
  record_largest(context, "distance/largest_relative_error", largest);
}

void run(ExperimentContext& context) {
  record_radii(context);
  record_distances(context);
}

}  // namespace

extern const ExperimentDescriptor circles_of_plants;
constinit const ExperimentDescriptor circles_of_plants{
    .id = "alsweis/circles-of-plants",
    .question = "Do the suite's circles have the radius and the distance of appendix A?",
    .source = "[Alsweis] appendix A, above (A.1), and (A.1)",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
