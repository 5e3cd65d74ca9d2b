// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// A day at a place.
struct SolarDay {
  double latitude = 0.0;   ///< degrees, north positive
  double longitude = 0.0;  ///< degrees, east positive
  int year = 2019;
  int month = 6;
  int day = 21;
};

/// Whether this build can say where the sun stands; if not, the functions below throw InputError
/// naming the library that is missing.
bool can_place_the_sun();

/// Where the sun's centre stands at a time of that day, in hours of universal time, without
/// refraction. Checked against the reference of Reda and Andreas 2004 to 0.01 degrees.
SunAngles solar_position(const SolarDay& day, double universal_time);

/// `hours` positions in equal steps from sunrise to sunset, at the middle of each step. Empty in
/// polar night.
std::vector<SunAngles> solar_path(const SolarDay& day, int hours);

/// How long the sun's centre is above the horizon, in hours, 0 to 24.
double daylight_hours(const SolarDay& day);

}  // namespace phytobench
