// SPDX-License-Identifier: MIT
// Distribution functions of distances to the nearest point. Conventions for all: a distance d
// counts at r if d <= r; the distances asked for are finite, not negative and strictly increasing,
// in the unit of the coordinates; points lie inside the window (ContractViolation otherwise); the
// result has a value per distance and the same bits for any number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// What makes up for nearer points that may stand beyond the border of a plot. On a torus nothing
/// is beyond, and all three agree up to rounding.
enum class DistanceCorrection {
  none,          ///< nothing: too few short distances, the fewer the longer the border
  border,        ///< at r only places at least r from the border ask (reduced sample); need not
                 ///< increase with r
  kaplan_meier,  ///< a distance is known up to the border only: censored there (Baddeley and Gill
                 ///< 1997, Ann. Stat. 25); increases, and uses every place
};

struct DistanceFunctionOptions {
  DistanceCorrection correction = DistanceCorrection::kaplan_meier;
  /// F asks at the cell centres of a grid of grid_side x grid_side equal cells over the window's
  /// bounding box, as far as they lie in the window; at least 1. The default keeps the error of the
  /// grid far below that of the pattern for up to some thousand points.
  std::size_t grid_side = 128;
  int threads = 1;
};

/// Estimate of the probability of a distance of at most r, for each of the increasing `asked`, from
/// distances measured at places `to_edge` from the border (sizes equal; both may be infinite). NaN
/// where no place may answer: without places and, for `border`, beyond all of them. Kaplan and
/// Meier's estimate stays constant beyond the last place.
std::vector<double> distance_distribution(std::span<const double> measured,
                                          std::span<const double> to_edge,
                                          std::span<const double> asked,
                                          DistanceCorrection correction);

/// G (Diggle 1979): distance from a point to its nearest other one. 1 - exp(-density pi r^2) under
/// complete spatial randomness, above it for clusters. NaN without points, 0 with a single one; 1
/// from r = 0 on if every point has a twin.
std::vector<double> nearest_neighbour_function(std::span<const Point2> points, const Window& window,
                                               std::span<const double> distances,
                                               const DistanceFunctionOptions& options = {});

/// F, the empty space function: distance from any place to the nearest point. The same under
/// complete spatial randomness, but below it for clusters. 0 without points; NaN if no place of the
/// grid lies in the window.
std::vector<double> empty_space_function(std::span<const Point2> points, const Window& window,
                                         std::span<const double> distances,
                                         const DistanceFunctionOptions& options = {});

/// J = (1 - G) / (1 - F) (van Lieshout and Baddeley 1996, Stat. Neerl. 50): 1 under complete
/// spatial randomness, below it for clusters, above it for regular patterns. NaN where F is 1 and
/// where G or F is NaN.
std::vector<double> j_function(std::span<const Point2> points, const Window& window,
                               std::span<const double> distances,
                               const DistanceFunctionOptions& options = {});

/// The places that F asks at, row by row from the lower left.
std::vector<Point2> test_grid(const Window& window, std::size_t side);

}  // namespace phytobench
