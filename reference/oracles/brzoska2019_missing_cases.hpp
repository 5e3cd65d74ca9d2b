// SPDX-License-Identifier: MIT
// Small cases of [Brzoska2019] that the text leaves out or names wrongly, in the plainest way.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench::oracles::brzoska2019 {

// Sec. 2.2: rings of `corners` points, each joined to the next by two triangles per corner.
inline std::vector<std::array<int, 3>> triangles_of_tube(int corners, int rings) {
  std::vector<std::array<int, 3>> triangles;
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int i = 0; i < corners; ++i) {
      const int a = ring * corners + i, b = ring * corners + (i + 1) % corners;
      triangles.push_back({a, b, a + corners});
      triangles.push_back({b, b + corners, a + corners});
    }
  return triangles;
}

// Sides that belong to one triangle only: a closed surface has none.
inline int open_sides(const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  int open = 0;
  for (const auto& [side, count] : uses) open += count == 1;
  return open;
}

// Sec. 3.4.5: a branch is turned about the axis across it and the vertical, by psi of eq. 13
// towards the ground. 0/0 for a branch that points straight up or down, which the thesis does not
// mention.
inline Point bent_as_printed(Point branch, double lambda) {
  const Point down{0, -1, 0};
  const Point axis = vector_product(branch, down);
  const double theta_deg =
      std::acos(scalar_product(branch, down) / length(branch)) * 180 / std::numbers::pi;
  const double psi_rad = equation_13(theta_deg, lambda) * std::numbers::pi / 180;
  return rotated(branch, over(axis, length(axis)), psi_rad);
}

// psi is 0 there: the branch stays.
inline Point bent_corrected(Point branch, double lambda) {
  if (length(vector_product(branch, {0, -1, 0})) > 0) return bent_as_printed(branch, lambda);
  return branch;
}

// Leaves of a plant with rings of `corners`: what its triangles have beyond the branches, by eight
// for each cross-foil of two squares with two sides.
inline double leaves_of_plant(double triangles, double edges, double corners) {
  return (triangles - 2 * corners * edges) / 8;
}

// Points of a cloud that is cut off below, eq. 21 and 22 (corrected).
inline double points_of_cloud(Point radii, double density, double cutoff_bottom) {
  const double volume = equation_21(radii.x * radii.y * radii.z, base_volume(cutoff_bottom, 0));
  return equation_22_corrected(volume, density);
}

}  // namespace phytobench::oracles::brzoska2019
