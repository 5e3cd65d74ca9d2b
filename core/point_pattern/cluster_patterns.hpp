// SPDX-License-Identifier: MIT
// Clustered patterns: seeds that fall near their parents ([Alsweis] sec. 2.4.1). The parents
// themselves are no points of the pattern.
#pragma once

#include <vector>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/window.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

enum class NumberLaw {
  poisson,  ///< a new Poisson number each time, with the given mean
  fixed,    ///< exactly the given number, which must be whole
};

/// How many parents and how many points around each.
struct ClusterNumbers {
  /// Mean number of parents per window area, >= 0. The dissertation's example: 20.
  double parents = 20.0;
  /// `fixed` is exact on a torus. A window with edges also needs parents beyond them: there the
  /// number for the wider region is rounded up or down at random, so that its mean is right.
  NumberLaw parents_law = NumberLaw::poisson;
  /// Mean number of points per parent, >= 0, before any fall outside. The example: 20.
  double offspring = 20.0;
  NumberLaw offspring_law = NumberLaw::poisson;
};

struct ThomasOptions {
  ClusterNumbers numbers;
  /// Standard deviation of either coordinate of the way from parent to point; the window's unit of
  /// length, >= 0. The dissertation's example: 0.05 on the unit torus.
  double sigma = 0.05;
};

struct MaternOptions {
  ClusterNumbers numbers;
  /// Points are uniform in the disc of this radius around their parent; the window's unit of
  /// length, >= 0.
  double radius = 0.1;
};

/// How far beyond a window with edges Thomas parents stand, in sigmas: a coordinate goes farther
/// once in 500 million points, so that the pattern is not thinner along the edges.
inline constexpr double thomas_margin_in_sigmas = 6.0;

/// The (modified) Thomas process: normal displacements. On a torus the points go round; in other
/// windows parents stand in the bounding box widened by thomas_margin_in_sigmas * sigma on all
/// sides, and points outside of the window are dropped. Points of one parent follow each other.
/// Order of draws: number of parents, then for each parent x, y, its number of points and their
/// displacements. ContractViolation for options out of range, InputError beyond most_points.
std::vector<Point2> thomas_points(const Window& window, const ThomasOptions& options,
                                  UnitStream& stream);

/// The Matern cluster process: as thomas_points(), uniform in a disc instead. The margin is the
/// disc's radius, which leaves no edge effect at all.
std::vector<Point2> matern_cluster_points(const Window& window, const MaternOptions& options,
                                          UnitStream& stream);

}  // namespace phytobench
