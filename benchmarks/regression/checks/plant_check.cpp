// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/plant_check.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/regression/checks/branch_mesh_check.hpp"
#include "benchmarks/regression/checks/leaf_check.hpp"
#include "core/contract/check.hpp"
#include "reference/oracles/brzoska2019_missing_cases.hpp"

namespace phytobench {

namespace {

namespace paper = oracles::brzoska2019;

std::string objection_to_skeleton(const Skeleton& found, const Skeleton& grown) {
  if (found.positions() == grown.positions() && found.parents() == grown.parents()) return {};
  return "its skeleton is not the one that was grown";
}

/// r^n = r1^n + ... + rk^n at every node, and the given radius at every tip.
std::string objection_to_radii(const Plant& plant, const PlantParameters& parameters) {
  const Skeleton& skeleton = plant.skeleton;
  if (plant.radii.size() != skeleton.node_count())
    return fmt::format("{} radii of {} nodes", plant.radii.size(), skeleton.node_count());
  std::vector<std::vector<double>> above(plant.radii.size());
  for (std::size_t i = 1; i < above.size(); ++i)
    above[static_cast<std::size_t>(skeleton.parents()[i])].push_back(plant.radii[i]);
  constexpr double rounding = 1e-9;  // of sums over thousands of tips
  for (std::size_t i = 0; i < above.size(); ++i) {
    const double expected = above[i].empty()
                                ? parameters.tip_radius
                                : paper::equation_12(above[i], parameters.radius_exponent);
    if (!(std::abs(plant.radii[i] - expected) <= rounding * expected))
      return fmt::format("node {}: radius {:.17g} instead of {:.17g}", i, plant.radii[i], expected);
  }
  return {};
}

std::string objection_to_numbers(const TriangleMesh& mesh) {
  constexpr double rounding = 1e-12;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!is_finite(mesh.positions[v])) return fmt::format("vertex {} is not finite", v);
  for (std::size_t v = 0; v < mesh.normals.size(); ++v)
    if (!(std::abs(norm(mesh.normals[v]) - 1.0) <= rounding))
      return fmt::format("the normal of vertex {} is not of length 1", v);
  return {};
}

/// The thesis tells its leaves from its triangles, eight for each cross-foil.
std::string objection_to_total(const Plant& plant, const PlantParameters& parameters) {
  if (parameters.leaves.shape != LeafShape::cross_foil) return {};
  const double leaves = paper::leaves_of_plant(
      static_cast<double>(plant.triangle_count()), static_cast<double>(plant.skeleton.edge_count()),
      static_cast<double>(parameters.branches.circle_resolution));
  if (leaves == static_cast<double>(plant.leaves.size())) return {};
  return fmt::format("{} triangles are those of {} leaves, not {}", plant.triangle_count(), leaves,
                     plant.leaves.size());
}

}  // namespace

std::string objection_to_plant(const Plant& plant, const Skeleton& grown,
                               const PlantParameters& parameters) {
  PHYTOBENCH_EXPECT(parameters.pendulous.intensity == 0.0);
  std::string wrong = objection_to_skeleton(plant.skeleton, grown);
  if (wrong.empty()) wrong = objection_to_radii(plant, parameters);
  if (wrong.empty()) wrong = objection_to_numbers(plant.branches.mesh);
  if (wrong.empty()) wrong = objection_to_numbers(plant.leaf_mesh);
  if (wrong.empty()) wrong = objection_to_total(plant, parameters);
  if (wrong.empty())
    wrong = objection_to_branch_mesh(plant.branches, grown, plant.radii, parameters.branches);
  if (wrong.empty())
    wrong = objection_to_leaves(plant.leaves, grown, plant.radii, parameters.leaves);
  if (wrong.empty())
    wrong = objection_to_leaf_mesh(plant.leaf_mesh, plant.leaves, parameters.leaves.shape);
  return wrong;
}

}  // namespace phytobench
