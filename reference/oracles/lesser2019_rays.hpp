// SPDX-License-Identifier: MIT
// Whether a ray of sunlight is blocked, by three readings of what a height map is between its
// numbers ([Lesser2019] leaves it open). Every ray for itself, every height asked, no early end;
// slow on purpose. Shares no code with core/.
#pragma once

#include <limits>
#include <vector>

#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::oracles::lesser2019 {

enum class Reading {
  surface,  // vertices of the mesh of sec. 8.3; straight between two of them on every grid line
  entry,    // flat-topped columns, the ray from the centre of one, blocked where it enters another
  foot,     // the same columns, compared where the ray is nearest to their centre
};

struct Ray {
  bool lit = true;
  // m between the ray and the terrain at the place where this is least; below 0 if it is blocked.
  // Infinite if nothing is in its way. Near 0 rounding decides.
  double margin = std::numeric_limits<double>::infinity();
  int compared = 0;
};

// The sun must not be in the zenith.
Ray ray(const Heights& map, int x, int y, const Direction& sun, Reading reading);

// Columns that a ray from a centre enters, in order, and its distance then along the direction.
// From corner to corner it goes diagonally.
struct EnteredCell {
  int i = 0, j = 0;
  double t = 0;
};
std::vector<EnteredCell> entered_cells(const Heights& map, int x, int y, const Direction& sun);

}  // namespace phytobench::oracles::lesser2019
