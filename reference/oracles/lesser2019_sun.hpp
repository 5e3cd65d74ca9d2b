// SPDX-License-Identifier: MIT
// The path of the sun by [Lesser2019] sec. 8.2.2 and 9.2.3: eq. 8.1, listings 9.7 and 9.11. Shares
// no code with core/.
#pragma once

#include <vector>

#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::oracles::lesser2019 {

// How many degrees the sun climbs in an hour.
enum class ElevationStep {
  listing,      // listing 9.11
  text,         // sec. 9.2.3: 90 / (13 / 2), written as a formula for any hours
  one_formula,  // the listing's formula for odd hours, used for all from three on
  tent,         // the same number of steps up and down, noon between two hours if they are even
};

// The loop around listing 9.11, which is not printed.
enum class Loop {
  half_up,     // as many steps up as half of the hours, then down
  level_noon,  // for even hours one step in the middle that keeps the elevation
};

enum class AzimuthStep {
  listing,      // two hours: symmetric to the south; more: half a turn from the start
  always_half,  // half a turn from the start
};

struct Day {
  int H = 13;     // hours of daylight
  double s0 = 0;  // elevation at the start
  double a0 = 0;  // azimuth at the start
  double M = 90;  // greatest elevation
  ElevationStep elevation = ElevationStep::listing;
  Loop loop = Loop::half_up;
  AzimuthStep azimuth = AzimuthStep::listing;
};

struct Angles {
  double elevation = 0, azimuth = 0;  // degrees
};

double elevation_per_hour(const Day& day);
double azimuth_per_hour(const Day& day);
std::vector<Angles> path(const Day& day);

// Eq. 8.1 with r = 1.
Direction equation_8_1(const Angles& sun);
// To four decimals, as Python's round() does it: the nearest by the exact value of the number.
double rounded_to_four(double value);
Direction listing_9_7(const Angles& sun);
std::vector<Direction> directions(const Day& day);  // listing 9.7 of the path

// Not in the thesis. Where the sun's centre stands (azimuth as above) at a latitude, with a
// declination and an hour angle that is 0 at noon and negative before; all degrees.
Angles true_sun(double latitude, double declination, double hour_angle);
double true_noon_elevation(double latitude, double declination);
// kcal/m2 that a horizontal area above the air gets in a day, with a solar constant in W/m2.
double top_of_atmosphere(double latitude, double declination, double solar_constant);

}  // namespace phytobench::oracles::lesser2019
