// SPDX-License-Identifier: MIT
// What one stand is like, in a few numbers.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// Of the plants of one species, or of all. Means and shares of no plants are NaN.
struct PlantStatistics {
  std::size_t plants = 0;
  double density = 0.0;                                           ///< plants per m^2 of ground
  double mean_radius = std::numeric_limits<double>::quiet_NaN();  ///< of stems, m
  double largest_radius = std::numeric_limits<double>::quiet_NaN();
  double basal_area = 0.0;                                 ///< of all stems together, m^2
  double gini = std::numeric_limits<double>::quiet_NaN();  ///< of the plants' basal areas
  double mean_loss = std::numeric_limits<double>::quiet_NaN();
  /// Part of the plants that lose more than half of their growth space, and so do not grow.
  double oppressed_share = std::numeric_limits<double>::quiet_NaN();
};

struct StandStatistics {
  std::vector<PlantStatistics> species;  ///< in the order of the parameters
  PlantStatistics all;
};

/// A plant that loses more does not grow ([Alsweis] (5.7); red in fig. 4.7).
constexpr bool is_oppressed(double loss) {
  return loss > 0.5;
}

/// `loss` in the order of the stand; `species` says how many there are, `ground_area` in m^2.
StandStatistics stand_statistics(const Stand& stand, std::span<const double> loss,
                                 std::size_t species, double ground_area);

/// How the plants of a stand lie to each other, whatever their species. NaN for fewer than two.
struct StandPattern {
  double clark_evans = 0.0;            ///< R: below 1 clustered, above 1 regular
  double hopkins = 0.0;                ///< exact, [Alsweis] (2.8): above 1 clustered
  double mean_nearest_distance = 0.0;  ///< to the nearest other plant, m
};

/// In the ground as window, without edges if it is a torus. The same for any number of threads.
StandPattern stand_pattern(const Stand& stand, const Rectangle& ground, bool is_torus,
                           int threads = 1);

}  // namespace phytobench
