// SPDX-License-Identifier: MIT
// Height fields and suns as the oracles of [Lesser2019] take them.
#pragma once

#include "core/terrain/height_field.hpp"
#include "core/terrain/sun/sun_direction.hpp"
#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::experiments::lesser2019 {

inline oracles::lesser2019::Heights oracle_map(const HeightField& field) {
  return {field.columns(),
          field.rows(),
          field.cell_width(),
          field.cell_depth(),
          {field.heights().begin(), field.heights().end()}};
}

inline oracles::lesser2019::Direction oracle_sun(const SunDirection& sun) {
  return {sun.east, sun.south, sun.up};
}

}  // namespace phytobench::experiments::lesser2019
