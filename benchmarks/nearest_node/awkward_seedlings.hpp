// SPDX-License-Identifier: MIT
// Small seedlings for tests, trials and watched benchmarks: clouds that tend to break an engine, a
// judge or a counter.
#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "core/colonization/growth.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

struct NamedSeedling {
  const char* name;
  Seedling seedling;
};

inline Seedling seedling_with(std::vector<Vector3> points, double influence, double kill,
                              int iterations) {
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.growth = {.iterations = iterations,
                     .step_length = 0.25,
                     .influence_distance = influence,
                     .perception_angle_rad = 160.0 * std::numbers::pi / 180.0,
                     .kill_distance = {.begin = kill, .end = 0.5 * kill}};
  return seedling;
}

/// Equal distances everywhere: steps and points share one lattice.
inline std::vector<Vector3> lattice(int half_width, double spacing) {
  std::vector<Vector3> points;
  for (int x = -half_width; x <= half_width; ++x)
    for (int y = 1; y <= 2 * half_width; ++y)
      for (int z = -half_width; z <= half_width; ++z)
        points.push_back({x * spacing, y * spacing, z * spacing});
  return points;
}

inline std::vector<Vector3> random_cube(std::size_t count, double scale = 1.0) {
  CounterStream stream(11, 0);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = stream.next_between(-1.0, 1.0);
    const double y = stream.next_between(0.0, 2.0);
    const double z = stream.next_between(-1.0, 1.0);
    points.push_back({scale * x, scale * y, scale * z});
  }
  return points;
}

inline std::vector<Vector3> repeated(std::vector<Vector3> points) {
  const std::vector<Vector3> once = points;
  points.insert(points.end(), once.begin(), once.end());
  return points;
}

/// A start with several nodes, so that nearest nodes are contested from the first iteration on.
inline Seedling with_crown_stem(Seedling seedling) {
  for (std::int32_t i = 0; i < 6; ++i) seedling.skeleton.append(i, {0.0, 0.25 * (i + 1), 0.0});
  return seedling;
}

inline Seedling scaled_growth(double scale) {
  Seedling seedling = seedling_with(random_cube(400, scale), 0.6 * scale, 0.3 * scale, 12);
  seedling.growth.step_length = 0.25 * scale;
  return seedling;
}

}  // namespace phytobench
