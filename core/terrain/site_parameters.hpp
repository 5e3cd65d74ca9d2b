// SPDX-License-Identifier: MIT
// What a site is made of besides its relief, and what grows there: the entries of [Lesser2019]
// sec. 8.1.
#pragma once

#include <string>

#include "core/terrain/quantities.hpp"

namespace phytobench {

/// What the air takes of the sun's energy before it reaches the ground, and what comes as water.
struct Biome {
  std::string name;
  double absorption_percent = 0.0;  ///< of the energy, taken up by the air
  double diffusion_percent = 0.0;   ///< scattered
  double cloud_percent = 0.0;       ///< thrown back by clouds; at most 100 together
  DailyWater rain;
  DailyWater groundwater;
};

struct Soil {
  std::string name;
  int id = 0;                     ///< grey level on a soil map
  double albedo = 0.0;            ///< share of the energy that is thrown back, 0 to 1
  double water_absorption = 1.0;  ///< share of the water that the soil takes up, 0 to 1
};

struct PlantSpecies {
  std::string name;
  DailyEnergy energy_demand;
  DailyWater water_demand;
  std::string soil;   ///< the name of the only one that it grows on; empty: any
  Length soil_depth;  ///< that its roots need
};

/// How the chance to grow falls with what is there of a factor, relative to what is needed.
enum class Tolerance {
  triangle,    ///< 1 at the need, 0 at none and at twice the need and more ([Lesser2019] sec. 8.6)
  saturating,  ///< the share of the need that is there, at most 1
  threshold,   ///< 1 if all that is needed is there, else 0
  ignored,     ///< 1
};

}  // namespace phytobench
