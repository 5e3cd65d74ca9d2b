// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// What makes up for the partners that a point near the border of a plot has beyond it.
enum class EdgeCorrection {
  none,         ///< nothing: estimates fall below the truth, the more the longer the distance
  border,       ///< only points at least the distance from the border ask (reduced sample);
                ///< any window with edges
  translation,  ///< a pair weighs area / area of the window's overlap with itself shifted by the
                ///< pair's difference (Ohser and Stoyan 1981); rectangles
  isotropic,    ///< a pair weighs 1 / share of the circle around its first point through its second
                ///< that is inside (Ripley 1976); rectangles and polygons
  torus,        ///< no correction, as there is no edge; tori, and they take no other
};

std::string_view name_of(EdgeCorrection correction);

bool is_defined(EdgeCorrection correction, WindowKind window);

/// The one to take unless there is a reason: translation, isotropic for polygons, torus for tori.
EdgeCorrection usual_correction(WindowKind window);

/// Share of the circle's circumference that lies inside the window, in [0, 1]: exact up to
/// rounding, from the arcs that the sides cut off. 1 for radius 0 and on a torus; the centre must
/// be inside.
double share_of_circle_inside(const Window& window, const Point2& centre, double radius);

/// What pairs of a pattern weigh under a correction that weighs pairs: 1 for `none` and `torus`.
class PairWeights {
 public:
  /// Expects a correction defined for the window, other than `border`, and for `isotropic` all
  /// points inside the window.
  PairWeights(std::span<const Point2> points, const Window& window, EdgeCorrection correction);

  bool all_one() const { return all_one_; }
  /// The same weight for either order of the pair.
  bool symmetric() const { return correction_ != EdgeCorrection::isotropic; }

  /// Weight of the ordered pair from point `first`, with the pair's difference and its length. A
  /// circle that meets the window in single points only has no share to divide by: 0, as there is
  /// no chance of such a pair.
  double operator()(std::size_t first, const Point2& difference, double distance) const;

 private:
  Window window_;
  EdgeCorrection correction_;
  bool all_one_;
  std::vector<Point2> points_;
  std::vector<double> to_edge_;
};

}  // namespace phytobench
