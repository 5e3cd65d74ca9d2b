// SPDX-License-Identifier: MIT
// Scenes in the plane for the tests of what [Liebemann2017] adds to space colonization.
#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "core/colonization/attraction_region.hpp"
#include "core/colonization/growth.hpp"

namespace phytobench {

/// The distances of fig. 3.2: influence 100, kill 20, step 15; no tropism, perceives all around.
inline Seedling flat_scene(std::vector<Vector3> points, const Vector3& root, int iterations) {
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.skeleton = Skeleton(root);
  seedling.growth.iterations = iterations;
  seedling.growth.step_length = 15.0;
  seedling.growth.influence_distance = 100.0;
  seedling.growth.perception_angle_rad = 2.0 * std::numbers::pi;
  seedling.growth.kill_distance = {.begin = 20.0, .end = 20.0};
  return seedling;
}

/// A quarter of the area and points of fig. 3.2, if it is a disc, with the root at its lowest
/// place.
inline Seedling disc_scene(std::uint64_t seed, int iterations = 200) {
  const auto stream = make_stream(StreamKind::counter, seed, 1);
  return flat_scene(attraction_points({.radius = 250.0}, 500, *stream), {0, -250, 0}, iterations);
}

}  // namespace phytobench
