// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/terrain/files/height_file.hpp"

namespace phytobench {

/// A map as its file has it.
struct PlacedMap {
  std::string name;  ///< for messages
  const GeoReference& place;
};

/// Throws InputError, which names both, where two maps of as many columns and rows cannot lie on
/// the same ground: a border of one is more than half a cell beside the other's, or both name a
/// projection and these differ in their kind, their unit or a number that both give. A map that
/// begins at (0, 0) does not say where it lies: only its size counts.
void refuse_other_ground(const PlacedMap& map, const PlacedMap& heights, int columns, int rows);

}  // namespace phytobench
