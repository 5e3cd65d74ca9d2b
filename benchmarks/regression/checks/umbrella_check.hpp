// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/component_graph/build_plant.hpp"

namespace phytobench {

/// Umbrellas on a ball, as [Lintermann1997] sec. 5.1 puts a dandelion together, with all numbers
/// regular and all stems straight.
struct UmbrellaPlant {
  /// A straight stem from ring to ring.
  struct Stem {
    double length = 1.0;
    int segments = 1;
    int corners = 3;
    double radius_first = 0.1, radius_last = 0.1;  ///< > 0
  };
  int umbrellas = 150;
  double ball_radius = 2.0;
  int hairs = 18;  ///< of each umbrella
  double tilt_deg = 65.0;
  Stem stalk{1.5, 4, 5, 0.05, 0.02};
  Stem hair{0.6, 3, 3, 0.012, 0.004};

  std::string graph() const;  ///< for parse_component_graph()
};

/// What is wrong with such a plant, in one line; empty if nothing. Instances follow from the links;
/// stalks stand on the ball at the heights and golden angles of an oracle that shares no code with
/// core/, each straight out; hairs leave its tip at the tilt, evenly around it; every vertex of
/// every ring lies at its radius, at right angles to its stem; triangles join neighbouring rings,
/// all of them once, and face outwards; normals do, too. Lengths to 1e-12 of the plant.
std::string objection_to_umbrellas(const BuiltPlant& built, const UmbrellaPlant& plant);

}  // namespace phytobench
