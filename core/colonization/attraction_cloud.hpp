// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// An ellipsoid whose top and bottom may be cut off by horizontal planes; the crown's space
/// ([Brzoska2019] sec. 5.2.1, fig. 34).
struct CutEllipsoid {
  Vector3 radii{5.0, 7.0, 4.5};  ///< length units, > 0
  double cutoff_bottom = 0.15;   ///< share of the full height cut off below, [0, 1)
  double cutoff_top = 0.05;      ///< share cut off above; both together < 1
};

/// Volume of the unit sphere between the two cutting planes: pi [(b - b^3/3) - (a - a^3/3)] with
/// a = -1 + 2 cutoff_bottom, b = 1 - 2 cutoff_top. The thesis names it V_base and prints no
/// formula.
double unit_segment_volume(double cutoff_bottom, double cutoff_top);

/// [Brzoska2019] eq. 21: determinant of the scaling matrix times the base volume.
double volume(const CutEllipsoid& shape);

/// Number of points for a density (points per unit volume): ceil(volume * density). Eq. 22 prints a
/// division; see erratum E2 of the paper. Throws InputError beyond 2^31 - 1 points.
std::size_t attraction_point_count(const CutEllipsoid& shape, double density);

/// Uniform points in the shape, whose bottom plane sits on `crown_root`. Rejection in the unit
/// sphere, the height drawn and tested first: the order of draws decides published counts.
std::vector<Vector3> attraction_points(const CutEllipsoid& shape, std::size_t count,
                                       const Vector3& crown_root, UnitStream& stream);

/// Smallest box around the points; empty for none.
BoundingBox extent_of(const std::vector<Vector3>& points);

}  // namespace phytobench
