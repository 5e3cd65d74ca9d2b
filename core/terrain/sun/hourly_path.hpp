// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// How the elevation goes up and down again when the number of hours is even, so that no hour is
/// noon. The thesis' own step misses what its text says ([Lesser2019] listing 9.11).
enum class EvenHours {
  plateau,  ///< the greatest elevation in both hours around noon
  tent,     ///< the same change every hour; noon lies between two hours
};

/// The simulated path of [Lesser2019] sec. 9.2.3: azimuth and elevation both in equal steps.
struct HourlyPath {
  int hours = 13;                ///< of daylight, at least 1
  double start_elevation = 0.0;  ///< degrees, 0 to 90; of the first and last hour
  double start_azimuth = 0.0;    ///< degrees from east over south; the path covers 180
  double max_elevation = 90.0;   ///< degrees, 0 to 90; at noon
  EvenHours even_hours = EvenHours::plateau;
};

/// Where the sun stands in each hour. One hour is at the start.
std::vector<SunAngles> sun_angles(const HourlyPath& path);

}  // namespace phytobench
