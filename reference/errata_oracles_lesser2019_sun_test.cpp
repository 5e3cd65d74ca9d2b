// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_relief.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench {

namespace {

namespace lesser = oracles::lesser2019;

constexpr double lesser_radian = 3.14159265358979323846 / 180.0;

lesser::Day day_of(double hours, double max_elevation) {
  return {.H = static_cast<int>(hours), .M = max_elevation};
}

lesser::Day with_step(lesser::Day day, lesser::ElevationStep chosen) {
  day.elevation = chosen;
  return day;
}

lesser::Day from_azimuth(const Arguments& a, lesser::AzimuthStep chosen) {
  return {.H = static_cast<int>(a[0]), .a0 = a[1], .azimuth = chosen};
}

double middle_elevation(const lesser::Day& day) {
  return lesser::path(day)[static_cast<std::size_t>(day.H / 2)].elevation;
}

/// A plane that rises to the south, row by row.
lesser::Heights rising_rows(double rise, double ps) {
  lesser::Heights map = lesser::flat(3, ps);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) map.at(i, j) = rise * j;
  return map;
}

/// Degrees, S_y over eight pixel sizes taken for the rise along the rows.
double rise_by_sobel(double rise, double ps) {
  return std::atan(lesser::equation_8_3(rising_rows(rise, ps), 1, 1).S_y / (8 * ps)) /
         lesser_radian;
}

/// Degrees from red over green, of half of each component of a normal plus a half.
double hue_of(const lesser::Normal& n) {
  const double red = (n.x + 1) / 2, green = (n.y + 1) / 2, blue = (n.z + 1) / 2;
  const double most = std::max({red, green, blue}), least = std::min({red, green, blue});
  double sixth = (red - green) / (most - least) + 4;
  if (most == red) sixth = (green - blue) / (most - least);
  if (most == green) sixth = (blue - red) / (most - least) + 2;
  return sixth * 60;
}

}  // namespace

OracleTable lesser2019_sun_oracles() {
  using lesser::ElevationStep;
  return {
      // Hours, greatest elevation; elevation in the middle hour by the formula of the text and by
      // the listing.
      {"lesser2019/elevation-at-noon",
       {2,
        [](const Arguments& a) {
          return middle_elevation(with_step(day_of(a[0], a[1]), ElevationStep::text));
        },
        [](const Arguments& a) { return middle_elevation(day_of(a[0], a[1])); }}},
      // Hours, elevation at the start, greatest one; elevation in the last hour.
      {"lesser2019/elevation-at-the-end",
       {3,
        [](const Arguments& a) {
          lesser::Day day = day_of(a[0], a[2]);
          day.s0 = a[1];
          return lesser::path(day).back().elevation;
        },
        [](const Arguments& a) {
          lesser::Day day = with_step(day_of(a[0], a[2]), ElevationStep::one_formula);
          day.s0 = a[1];
          return lesser::path(day).back().elevation;
        }}},
      // Hours, azimuth at the start; azimuth in the last hour.
      {"lesser2019/azimuth-at-the-end",
       {2,
        [](const Arguments& a) {
          return lesser::path(from_azimuth(a, lesser::AzimuthStep::listing)).back().azimuth;
        },
        [](const Arguments& a) {
          return lesser::path(from_azimuth(a, lesser::AzimuthStep::always_half)).back().azimuth;
        }}},
      // Latitude, declination; elevation at noon, as if the equator always had the zenith.
      {"lesser2019/noon-in-summer",
       {2, [](const Arguments& a) { return a[0] == 0 ? 90.0 : 90 - std::abs(a[0] - a[1]); },
        [](const Arguments& a) { return lesser::true_noon_elevation(a[0], a[1]); }}},
      // Rise from row to row, pixel size; rise to the south by S_y of eq. 8.3, and by the normal
      // that
      // faces downhill.
      {"lesser2019/rise-along-the-rows",
       {2, [](const Arguments& a) { return rise_by_sobel(a[0], a[1]); },
        [](const Arguments& a) {
          const lesser::Normal n = lesser::sobel_corrected(rising_rows(a[0], a[1]), 1, 1);
          return std::atan2(-n.y, n.z) / lesser_radian;
        }}},
      // Slope to the north; its hue.
      {"lesser2019/hue-of-a-slope-to-the-north",
       {1, [](const Arguments&) { return 0.0; },  // red
        [](const Arguments& a) {
          return hue_of({0, -std::sin(a[0] * lesser_radian), std::cos(a[0] * lesser_radian)});
        }}},
      // Hours, greatest elevation; energy of flat ground in a day.
      {"lesser2019/raw-energy-of-flat-ground",
       {2, [](const Arguments& a) { return lesser::raw_energy_of_flat_ground(day_of(a[0], a[1])); },
        [](const Arguments& a) { return lesser::raw_energy_by_height(day_of(a[0], a[1])); }}},
  };
}

}  // namespace phytobench
