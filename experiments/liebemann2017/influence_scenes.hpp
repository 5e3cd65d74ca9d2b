// SPDX-License-Identifier: MIT
// Influence points and roots for space colonization as [Liebemann2017] sec. 3.3 has it, with the
// distances of figure 3.2.
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/colonization/attraction_region.hpp"
#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::liebemann2017 {

/// The caption of figure 3.2.
inline constexpr std::size_t ring_points = 2000;       // N
inline constexpr double ring_radius = 500.0;           // r
inline constexpr double influence_radius = 100.0;      // d_i
inline constexpr double minimal_radius = 20.0;         // d_k
inline constexpr double step_length = 15.0;            // D
inline constexpr double tip_radius = 1.0, ring_g = 2;  // r_0 and g
/// Not printed; the text asks for some maximum.
inline constexpr int most_iterations = 400;

/// As printed: nodes may repeat, and nothing is known of an angle of perception.
inline Seedling scene(std::vector<Vector3> points, const Vector3& root,
                      int iterations = most_iterations) {
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.skeleton = Skeleton(root);
  GrowthParameters& growth = seedling.growth;
  growth.iterations = iterations;
  growth.step_length = step_length;
  growth.influence_distance = influence_radius;
  growth.perception_angle_rad = 2.0 * std::numbers::pi;
  growth.kill_distance.begin = growth.kill_distance.end = minimal_radius;
  growth.variant.repeat_guard = RepeatGuard::off;
  return seedling;
}

/// With a condition that the text does not have: no second successor at the place of a first one.
inline Seedling without_repeats(Seedling seedling) {
  seedling.growth.variant.repeat_guard = RepeatGuard::on;
  return seedling;
}

/// Clouds of one run; another number of a cloud stands for other points.
inline std::vector<Vector3> cloud(const RoundRegion& region, std::size_t count, std::uint64_t seed,
                                  std::uint64_t number) {
  CounterStream stream(seed, 3200 + number);
  return attraction_points(region, count, stream);
}

inline RoundRegion round_region(RoundShape shape, double radius, double inner_radius = 0.0) {
  RoundRegion region;
  region.shape = shape;
  region.radius = radius;
  region.inner_radius = inner_radius;
  return region;
}

inline GrowthResult grow(const Seedling& seedling) {
  const auto engine = engine_named("squared_scan").create();
  return grow_crown(seedling, *engine);
}

inline std::int64_t nodes_of(const GrowthResult& result) {
  return static_cast<std::int64_t>(result.skeleton.node_count());
}
inline std::int64_t iterations_that_grew(const GrowthResult& result) {
  std::int64_t grew = 0;
  for (const PassStatistics& pass : result.passes) grew += pass.new_nodes > 0;
  return grew;
}
inline std::string stop_of(const GrowthResult& result) {
  return std::string(name_of(result.stop_reason));
}

/// Positions agree up to rounding.
inline bool same_place(const Vector3& a, const Vector3& b) {
  return norm(a - b) <= 1e-9;
}

inline bool same_tree(const Skeleton& a, const Skeleton& b) {
  bool same = a.node_count() == b.node_count();
  for (std::size_t v = 0; same && v < a.node_count(); ++v)
    same = a.parents()[v] == b.parents()[v] && same_place(a.positions()[v], b.positions()[v]);
  return same;
}

}  // namespace phytobench::experiments::liebemann2017
