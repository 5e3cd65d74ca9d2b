// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/workload.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/csv_file.hpp"
#include "core/contract/errors.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench {

namespace {

TreeParameters test_tree() {
  return read_tree_parameters(tree_preset_file("figure-51"));
}

int scaled_iterations(const TreeParameters& tree, double scale) {
  return std::max(1, static_cast<int>(std::lround(tree.iterations * scale)));
}

/// Volume of the ellipsoid in the box. A flat box is taken to be a thousandth as thick as long.
double volume_of(const BoundingBox& box) {
  const Vector3 extent = box.extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  double volume = std::numbers::pi / 6.0;
  for (const double length : {extent.x, extent.y, extent.z})
    volume *= std::max(length, 1e-3 * longest);
  return volume;
}

}  // namespace

Workload scaled_test_tree(const WorkloadRequest& request) {
  constexpr double most_points = 2e8;
  if (!(request.points >= 1.0 && request.points <= most_points))
    throw InputError(
        fmt::format("--points {} is out of range; give 1 to {}", request.points, most_points));
  constexpr std::uint64_t largest_seed = std::numeric_limits<std::int32_t>::max();
  if (request.seed > largest_seed)
    throw InputError(
        fmt::format("--seed {} is out of range; give 0 to {}", request.seed, largest_seed));
  TreeParameters tree = test_tree();
  const double density = request.density > 0.0 ? request.density : tree.cloud_density;
  const double own_points = std::ceil(volume(tree.cloud) * tree.cloud_density);
  const double size = std::cbrt(request.points / own_points);
  const double length = std::cbrt(tree.cloud_density / density) * size;
  tree.cloud.radii = length * tree.cloud.radii;
  tree.cloud_density = density;
  tree.iterations = request.iterations > 0 ? request.iterations : scaled_iterations(tree, length);
  tree.seed = request.seed;
  return {"scaled test tree of [Brzoska2019] Table 1", request.seed, density, make_seedling(tree)};
}

std::vector<Vector3> read_points(const std::filesystem::path& file) {
  const auto columns = read_number_columns(file, {"x", "y", "z"});
  constexpr double largest = 1e100, smallest = 1e-90;  // volumes must not over- or underflow
  std::vector<Vector3> points;
  points.reserve(columns.front().size());
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    const Vector3 point{columns[0][i], columns[1][i], columns[2][i]};
    if (std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) > largest)
      throw InputError(fmt::format("{}: point {} has a coordinate beyond {}; use a larger unit",
                                   file.string(), i, largest));
    points.push_back(point);
  }
  const Vector3 extent = extent_of(points).extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (longest > 0.0 && longest < smallest)
    throw InputError(
        fmt::format("{}: all points lie within {}; use a smaller unit", file.string(), smallest));
  return points;
}

Workload workload_from_points(std::vector<Vector3> points, const std::string& name,
                              int iterations) {
  const TreeParameters tree = test_tree();
  const BoundingBox box = extent_of(points);
  const auto count = static_cast<double>(points.size());
  const double space = volume_of(box);
  const double length = space > 0.0 ? std::cbrt(tree.cloud_density * space / count) : 1.0;
  const double size = std::cbrt(count / std::ceil(volume(tree.cloud) * tree.cloud_density));

  const Vector3 low = box.low(), extent = box.extent();
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.skeleton = Skeleton({low.x + 0.5 * extent.x, low.y, low.z + 0.5 * extent.z});
  KillDistanceSchedule kill = tree.kill_distance;
  kill.begin *= length;
  kill.end *= length;
  seedling.growth = {.iterations = iterations > 0 ? iterations : scaled_iterations(tree, size),
                     .step_length = length * tree.step_length,
                     .influence_distance = length * tree.influence_distance,
                     .perception_angle_rad = tree.perception_angle_deg * std::numbers::pi / 180.0,
                     .kill_distance = kill,
                     .tropism = tree.tropism_direction,
                     .variant = tree.variant};
  return {name, 0, space > 0.0 ? count / space : 0.0, std::move(seedling)};
}

}  // namespace phytobench
