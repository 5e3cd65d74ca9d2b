// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// How strongly a plant is felt around it (Berger and Hildenbrandt 2000, Ecological Modelling 132):
/// 1 over its stem, falling exponentially to `at_rim` at the rim of its zone, 0 beyond.
class NeighbourField {
 public:
  /// Lengths in one unit, 0 < stem_radius; a zone no wider than the stem is the stem, and has no
  /// slope. 0 < at_rim < 1.
  NeighbourField(double stem_radius, double zone_radius, double at_rim);

  double at(double distance) const;

  /// Integral over the disc of this radius around the plant itself.
  double over_own_disc(double radius) const;

  /// Integral over a disc whose center lies at `distance` from the stem; to a relative error of
  /// 1e-9.
  double over_disc(double radius, double distance) const;

 private:
  class Boundary;

  /// Of over_disc(): integral over the boundary's piece between two distances from the stem.
  double over_boundary(const Boundary& boundary, double near, double far) const;

  double stem_;
  double zone_;
  double slope_;  ///< c: field = exp(-c (r - stem))
};

}  // namespace phytobench
