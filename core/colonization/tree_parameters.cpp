// SPDX-License-Identifier: MIT
#include "core/colonization/tree_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/colonization/stem.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

// Streams of the counter-based generator; the subtractive one restarts from the seed for each.
enum Stream : std::uint64_t { cloud_stream = 1, stem_stream = 2, crown_stem_stream = 3 };

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

std::vector<Vector3> sample_cloud(const TreeParameters& p, double density,
                                  const Vector3& crown_root) {
  const auto stream = make_stream(p.random, p.seed, cloud_stream);
  if (p.round_cloud) {
    RoundRegion region = p.round_cloud->region;
    region.centre = crown_root + region.centre;
    return attraction_points(region, p.round_cloud->points, *stream);
  }
  return attraction_points(p.cloud, attraction_point_count(p.cloud, density), crown_root, *stream);
}

std::int32_t grow_stem(const TreeParameters& p, Stream which, double length, std::int32_t foot,
                       Skeleton& skeleton) {
  constexpr double most_pieces = 1e6;
  if (length / p.step_length > most_pieces)
    throw InputError(
        fmt::format("stem of length {:.4g} in pieces of {:.4g} would need more than {:.0g} "
                    "nodes; raise growth.step_length or shorten the stem",
                    length, p.step_length, most_pieces));
  const auto stream = make_stream(p.random, p.seed, which);
  return append_stem(skeleton, foot, length, p.step_length, radians(p.stem_tilt_deg), *stream);
}

Vector3 weighted_tropism(const TreeParameters& p, const Seedling& seedling,
                         const Vector3& crown_root) {
  Vector3 weights = p.tropism_weights;
  if (p.tropism_damping == TropismDamping::cloud_shape) {
    const bool own_cloud = p.tropism_damping_density == 0.0;
    const BoundingBox box =
        extent_of(own_cloud ? seedling.attraction_points
                            : sample_cloud(p, p.tropism_damping_density, crown_root));
    weights.y *= tropism_damping_weight(box.extent());
  }
  return hadamard_product(weights, p.tropism_direction);
}

}  // namespace

double tropism_damping_weight(const Vector3& extent) {
  const double ratio = extent.y / std::max(extent.x, extent.z);
  return std::isfinite(ratio) ? std::min(1.0, ratio * ratio) : 1.0;
}

Seedling make_seedling(const TreeParameters& p) {
  Seedling seedling;
  // Grow the stem below the crown.
  Skeleton& skeleton = seedling.skeleton;
  seedling.crown_root = grow_stem(p, stem_stream, p.stem_length, 0, skeleton);
  const Vector3 crown_root = skeleton.position(seedling.crown_root);
  if (seedling.crown_root > 0) {
    const Vector3 last = crown_root - skeleton.position(seedling.crown_root - 1);
    seedling.crown_root_direction = last / norm(last);
  }
  // Fill the crown's space with points.
  seedling.attraction_points = sample_cloud(p, p.cloud_density, crown_root);
  // Continue the stem into the crown.
  const double height = extent_of(seedling.attraction_points).extent().y;
  grow_stem(p, crown_stem_stream, p.crown_stem_ratio * height, seedling.crown_root, skeleton);

  seedling.growth = {.iterations = p.iterations,
                     .step_length = p.step_length,
                     .influence_distance = p.influence_distance,
                     .perception_angle_rad = radians(p.perception_angle_deg),
                     .kill_distance = p.kill_distance,
                     .tropism = weighted_tropism(p, seedling, crown_root),
                     .variant = p.variant,
                     .limits = p.limits};
  return seedling;
}

TreeOnStem regrow_stem(const TreeOnStem& tree, const TreeParameters& p) {
  TreeOnStem regrown;
  Skeleton& skeleton = regrown.skeleton;
  regrown.crown_root = grow_stem(p, stem_stream, p.stem_length, 0, skeleton);
  const Vector3 old_root = tree.skeleton.position(tree.crown_root);
  const Vector3 new_root = skeleton.position(regrown.crown_root);
  const std::int32_t shift = regrown.crown_root - tree.crown_root;
  skeleton.reserve(tree.skeleton.node_count() + static_cast<std::size_t>(std::max(shift, 0)));
  for (auto i = static_cast<std::size_t>(tree.crown_root) + 1; i < tree.skeleton.node_count(); ++i)
    skeleton.append(tree.skeleton.parents()[i] + shift,
                    new_root + (tree.skeleton.positions()[i] - old_root));
  return regrown;
}

std::string why_growth_cannot_start(const Seedling& seedling) {
  if (seedling.attraction_points.empty())
    return "growth cannot start: the cloud has no attraction points; raise cloud.density or "
           "cloud.radii";
  double nearest = std::numeric_limits<double>::infinity();
  for (const SearchableNode& node : start_nodes(seedling))
    for (const Vector3& point : seedling.attraction_points)
      nearest = std::min(nearest, squared_distance(node.position, point));
  const double gap = std::sqrt(nearest);
  const double reach = seedling.growth.influence_distance;
  if (gap > reach)
    return fmt::format(
        "growth cannot start: the nearest attraction point is {:.4g} away from the crown root, "
        "beyond "
        "growth.influence_distance = {:.4g}; raise growth.influence_distance above {:.4g}, raise "
        "cloud.density, or lengthen stem.crown_ratio into the cloud",
        gap, reach, gap);
  return fmt::format(
      "growth cannot start: points lie within growth.influence_distance = {:.4g} (nearest {:.4g}), "
      "but "
      "none within growth.perception_angle_deg = {:.4g} of the stem's direction; widen the angle, "
      "raise "
      "growth.influence_distance or cloud.density",
      reach, gap, seedling.growth.perception_angle_rad * 180.0 / std::numbers::pi);
}

}  // namespace phytobench
