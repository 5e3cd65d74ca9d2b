// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/plant_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

class PlantCheck {
 public:
  PlantCheck(const Plant& plant, const Skeleton& grown, const PlantParameters& parameters)
      : plant_(plant), grown_(grown), parameters_(parameters) {}

  std::string run() const {
    if (plant_.radii.size() != grown_.node_count())
      return fmt::format("{} radii of {} nodes", plant_.radii.size(), grown_.node_count());
    for (const auto check : {&PlantCheck::radii, &PlantCheck::counts, &PlantCheck::rings,
                             &PlantCheck::leaf_count, &PlantCheck::numbers})
      if (const std::string wrong = (this->*check)(); !wrong.empty()) return wrong;
    return {};
  }

 private:
  std::size_t parent_of(std::size_t node) const {
    return static_cast<std::size_t>(grown_.parents()[node]);
  }

  /// r^n = r1^n + ... + rk^n at every node, and the given radius at every tip.
  std::string radii() const {
    const double n = parameters_.radius_exponent;
    std::vector<double> sums(plant_.radii.size(), 0.0);
    for (std::size_t i = 1; i < sums.size(); ++i)
      sums[parent_of(i)] += std::pow(plant_.radii[i], n);
    constexpr double rounding = 1e-9;  // of sums over thousands of tips
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double expected = sums[i] > 0.0 ? std::pow(sums[i], 1.0 / n) : parameters_.tip_radius;
      if (!(std::abs(plant_.radii[i] - expected) <= rounding * expected))
        return fmt::format("node {}: radius {:.17g} instead of {:.17g}", i, plant_.radii[i],
                           expected);
    }
    return {};
  }

  std::size_t duplicated_rings() const {
    std::size_t count = 0;
    for (std::size_t i = 1; i < plant_.radii.size(); ++i)
      count += plant_.radii[i] <= parameters_.branches.duplicate_ratio * plant_.radii[parent_of(i)];
    return count;
  }

  std::string counts() const {
    const auto corners = static_cast<std::size_t>(parameters_.branches.circle_resolution);
    const std::size_t edges = grown_.edge_count();
    const bool is_cross = parameters_.leaves.shape == LeafShape::cross_foil;
    const std::size_t squares = plant_.leaves.size() * (is_cross ? 2 : 1);
    struct Count {
      const char* what;
      std::size_t found, expected;
    };
    for (const auto& [what, found, expected] :
         {Count{"vertices of branches", plant_.branches.mesh.vertex_count(),
                (corners + 1) * (edges + 1 + duplicated_rings())},
          Count{"triangles of branches", plant_.branches.mesh.triangle_count(),
                2 * corners * edges},
          Count{"vertices of leaves", plant_.leaf_mesh.vertex_count(), 8 * squares},
          Count{"triangles of leaves", plant_.leaf_mesh.triangle_count(), 4 * squares}})
      if (found != expected) return fmt::format("{} {} instead of {}", found, what, expected);
    return {};
  }

  /// Rings are in node order: the corners of each lie at the node's radius around it.
  std::string rings() const {
    const auto ring_size = static_cast<std::size_t>(parameters_.branches.circle_resolution) + 1;
    constexpr double rounding = 1e-9;  // of a radius, for places thousands of radii from the origin
    for (std::size_t v = 0; v < ring_size * grown_.node_count(); ++v) {
      const std::size_t node = v / ring_size;
      const double away = norm(plant_.branches.mesh.positions[v] - grown_.positions()[node]);
      if (!(std::abs(away - plant_.radii[node]) <= rounding * plant_.radii[node]))
        return fmt::format("vertex {}: {:.17g} from node {} of radius {:.17g}", v, away, node,
                           plant_.radii[node]);
    }
    return {};
  }

  std::string leaf_count() const {
    double bearing = 0.0;
    for (std::size_t i = 1; i < plant_.radii.size(); ++i)
      bearing += plant_.radii[i] < parameters_.leaves.radius_limit;
    const double per_node = parameters_.leaves.per_node;
    const double chance = per_node - std::floor(per_node);
    const double deviation = std::sqrt(bearing * chance * (1.0 - chance));
    const auto found = static_cast<double>(plant_.leaves.size());
    if (std::abs(found - bearing * per_node) <= 5.0 * deviation) return {};
    return fmt::format("{} leaves on {} nodes that may carry them", found, bearing);
  }

  std::string numbers() const {
    for (const TriangleMesh* mesh : {&plant_.branches.mesh, &plant_.leaf_mesh}) {
      constexpr double rounding = 1e-12;
      for (std::size_t v = 0; v < mesh->vertex_count(); ++v)
        if (!is_finite(mesh->positions[v]) || !(std::abs(norm(mesh->normals[v]) - 1.0) <= rounding))
          return fmt::format("vertex {} is not finite, or its normal not of length 1", v);
      for (const Triangle& triangle : mesh->triangles)
        if (*std::max_element(triangle.begin(), triangle.end()) >= mesh->vertex_count())
          return "a triangle has a vertex that is not there";
    }
    return {};
  }

  const Plant& plant_;
  const Skeleton& grown_;
  const PlantParameters& parameters_;
};

}  // namespace

std::string objection_to_plant(const Plant& plant, const Skeleton& grown,
                               const PlantParameters& parameters) {
  PHYTOBENCH_EXPECT(parameters.pendulous.intensity == 0.0);
  return PlantCheck(plant, grown, parameters).run();
}

}  // namespace phytobench
