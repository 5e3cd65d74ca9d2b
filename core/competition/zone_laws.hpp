// SPDX-License-Identifier: MIT
// What two overlapping zones cost their plants, in area. Rules add these up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/competition/competition_rule.hpp"

namespace phytobench {

/// Ground of its own zone that each plant of a pair cannot use; less than 0 where it is helped.
struct PairLosses {
  double first = 0.0;
  double second = 0.0;
};

constexpr PairLosses operator*(double factor, const PairLosses& losses) {
  return {factor * losses.first, factor * losses.second};
}

constexpr PairLosses operator+(const PairLosses& a, const PairLosses& b) {
  return {a.first + b.first, a.second + b.second};
}

/// Both lose half of the overlap ([Alsweis] (4.2), (5.1)).
constexpr PairLosses equal_losses(double overlap) {
  return {0.5 * overlap, 0.5 * overlap};
}

/// The part of the overlap that the first plant loses where the larger wins all: 1, 0, or as the
/// tie rule says ([Alsweis] (4.3), (5.2) as losses).
inline double lost_by_first(const CompetingPlants& plants, const Discs& zone, TieRule ties,
                            std::size_t i, std::size_t j) {
  const double r_i = zone.radius[i], r_j = zone.radius[j];
  if (r_i != r_j) return r_i < r_j ? 1.0 : 0.0;
  if (ties == TieRule::share) return 0.5;
  const bool first_is_lower = plants.id.empty() ? i < j : plants.id[i] < plants.id[j];
  return first_is_lower ? 0.0 : 1.0;
}

/// Of the larger crown's five rings of equal width, 1 (innermost) to 5, the innermost that a
/// smaller crown at this distance reaches: F of [Alsweis] (5.3). Beyond the crown it is 5.
inline int zone_index(double distance, double smaller, double larger) {
  constexpr int rings = 5;
  const double reached = std::ceil(rings * ((distance - smaller) / larger));
  return static_cast<int>(std::clamp(reached, 1.0, static_cast<double>(rings)));
}

/// Weight of a contact in ring F: 1 in the three inner ones, 3 / F in the outer two ([Alsweis]
/// (5.3), (5.4)).
constexpr double ring_weight(int zone) {
  return zone <= 3 ? 1.0 : 3.0 / zone;
}

/// How far apart the stems are whose zones have this very overlap. On a torus two plants may meet
/// across more than one border: the overlap tells which image it belongs to.
double distance_of_pair(const Discs& zone, const Ground& ground, std::size_t i, std::size_t j,
                        double overlap);

constexpr double disc_area(double radius) {
  return std::numbers::pi * radius * radius;
}

}  // namespace phytobench
