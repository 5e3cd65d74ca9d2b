// SPDX-License-Identifier: MIT
// Sec. 4 and 5.1: the golden section on parts of a sphere, against an oracle, against other angles,
// and against the rule for the plane that it extends.
#include <limits>

#include "core/component_graph/shapes/outward_frame.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

struct Cap {
  double first_deg, last_deg;
};
constexpr Cap caps[] = {{0.0, 180.0}, {0.0, 90.0}, {0.0, 20.0}, {0.0, 0.5}, {35.0, 110.0}};
constexpr std::size_t numbers[] = {100, 300, 1000};

std::vector<Vector3> places(std::size_t n, const Cap& cap, const std::string& keys = "") {
  const SingleComponent ball(
      "phiball", fmt::format("count = {}\npolar_first = {}\npolar_last = {}\n{}", n, cap.first_deg,
                             cap.last_deg, keys));
  std::vector<Vector3> places;
  for (const Frame& child : ball.children(n)) places.push_back(child.origin);
  return places;
}

double closest_distance(const std::vector<Vector3>& places) {
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) closest = std::fmin(closest, norm(places[i] - places[j]));
  return closest;
}

/// The oracle's pole is +z and its azimuth begins at x: here they are y and z.
double distance_to_oracle(std::size_t n, const Cap& cap) {
  const std::vector<Vector3> here = places(n, cap);
  const auto there = oracle::places_on_cap(static_cast<int>(n), 1.0, cap.first_deg, cap.last_deg);
  double greatest = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    greatest = std::fmax(greatest, norm(here[i] - Vector3{there[i].y, there[i].z, there[i].x}));
  return greatest;
}

void record_spheres(ExperimentContext& context) {
  double step_deviation = 0.0, to_oracle = 0.0;
  for (const std::size_t n : numbers) {
    const std::vector<Vector3> here = places(n, caps[0]);
    Vector3 sum;
    for (const Vector3& place : here) sum = sum + place;
    const std::string name = fmt::format("n-{}/", n);
    context.record(name + "separation", closest_distance(here) * std::sqrt(static_cast<double>(n)));
    context.record(name + "centroid", norm(sum) / static_cast<double>(n));
    for (std::size_t i = 1; i < n; ++i)
      step_deviation = std::fmax(step_deviation, std::abs(azimuth_step_deg(here[i - 1], here[i]) -
                                                          oracle::golden_angle_deg()));
    for (const Cap& cap : caps) to_oracle = std::fmax(to_oracle, distance_to_oracle(n, cap));
  }
  context.record("golden_angle", golden_angle_deg, "degrees");
  context.record("step_deviation", step_deviation, "degrees");
  context.record("distance_to_oracle", to_oracle);
}

/// How far the number of places in a smaller part of the cap is from its share of the area, at
/// most: 1/2 if each place has an area of its own.
void record_areas(ExperimentContext& context) {
  constexpr std::size_t n = 300;
  double most = 0.0;
  for (const Cap& cap : caps) {
    const std::vector<Vector3> here = places(n, cap);
    const double top = std::cos(radians(cap.first_deg)), bottom = std::cos(radians(cap.last_deg));
    for (std::size_t i = 0; i < n; ++i) {
      const double share = (top - here[i].y) / (top - bottom);
      const double before = static_cast<double>(i);  // places above this one
      most = std::fmax(most, std::abs(share * static_cast<double>(n) - before));
    }
  }
  context.record("deviation_from_share_of_area", most, "places");
}

/// In the plane the i-th place is sqrt(i) from the middle; on the sphere so is the chord from the
/// pole, whatever the size of the cap.
void record_plane_rule(ExperimentContext& context) {
  constexpr std::size_t n = 300;
  double deviation = 0.0;
  for (const Cap& cap : caps) {
    if (cap.first_deg != 0.0) continue;
    const double edge = 2.0 * std::sin(radians(0.5 * cap.last_deg));
    const std::vector<Vector3> here = places(n, cap);
    for (std::size_t i = 0; i < n; ++i) {
      const double chord = norm(here[i] - Vector3{0.0, 1.0, 0.0});
      const double plane = edge * std::sqrt((static_cast<double>(i) + 0.5) / n);
      deviation = std::fmax(deviation, std::abs(chord / plane - 1.0));
    }
  }
  context.record("deviation_from_plane_rule", deviation);
}

/// The same bands with another angle from child to child.
void record_other_angles(ExperimentContext& context) {
  constexpr std::size_t n = 300;
  for (const double angle : {90.0, 120.0, 135.0, 137.0, 138.0, 144.0, 360.0 - golden_angle_deg}) {
    const std::string keys =
        fmt::format("azimuth = \"(i - 1) * ({} - {})\"", angle, golden_angle_deg);
    context.record(fmt::format("other_angle/{:.0f}/separation", angle),
                   closest_distance(places(n, caps[0], keys)) * std::sqrt(300.0));
  }
}

void run(ExperimentContext& context) {
  record_spheres(context);
  record_areas(context);
  record_plane_rule(context);
  record_other_angles(context);
}

}  // namespace

extern const ExperimentDescriptor golden_section;
constinit const ExperimentDescriptor golden_section{
    .id = "lintermann1997/golden-section",
    .question = "How does a phiball spread its children over parts of a sphere?",
    .source = "[Lintermann1997] sec. 4, 5.1",
    .seconds = {0.05, 0.05, 0.05},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
