// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// How a plant is felt around its stem (Berger and Hildenbrandt 2000): 1 over the stem, then
/// falling exponentially to `at_rim` at the rim of its zone, 0 beyond. Lengths > 0, 0 < at_rim < 1.
struct LiteralField {
  double stem = 0.0;  ///< radius; a zone no wider than it is felt as 1 all over
  double zone = 0.0;  ///< radius
  double at_rim = 0.0;
};

/// Integral of the field over a disc of this radius > 0 whose center is `distance` >= 0 from the
/// stem: circle by circle around the stem, each with the arc of it that lies in the disc. To some
/// 1e-12 of the disc's area. Shares no code with core/, where the boundary is integrated along.
double field_over_disc(const LiteralField& field, double radius, double distance);

}  // namespace phytobench
