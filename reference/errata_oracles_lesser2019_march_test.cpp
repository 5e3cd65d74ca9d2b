// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_rays.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench {

namespace {

namespace lesser = oracles::lesser2019;

/// 16 x 16 flat pixels of 16 m with a tower.
lesser::Heights map_with_tower(const Arguments& a) {
  lesser::Heights map = lesser::flat(16, 16);
  map.at(static_cast<int>(a[2]), static_cast<int>(a[3])) = a[4];
  return map;
}

double lit_or_undefined(lesser::Outcome outcome) {
  if (outcome == lesser::Outcome::lit) return 1;
  return outcome == lesser::Outcome::dark ? 0 : undefined;
}

/// A ray over flat ground that is taken for lower than the map's highest place.
double end_over_ground(const Arguments& a, const lesser::MarchForm& form) {
  const lesser::Heights ground = lesser::flat(static_cast<int>(a[1]), a[0]);
  lesser::Direction sun = lesser::listing_9_7({0, a[2]});
  sun.w = 0;
  return lit_or_undefined(
      lesser::PrintedMarch(ground, form).over(0, static_cast<int>(a[3]), 0, sun, 1).outcome);
}

double comparisons_off_the_map(const Arguments& a, bool truncates) {
  const lesser::Heights ground = lesser::flat(32, a[3]);
  lesser::Direction sun = lesser::directions({})[static_cast<std::size_t>(a[2]) - 1];
  sun.w = 0;
  double outside = 0;
  for (const lesser::Visited& one :
       lesser::PrintedMarch(ground, {.truncates = truncates})
           .over(static_cast<int>(a[0]), static_cast<int>(a[1]), 0, sun, 1)
           .visited)
    outside += one.X < 0 || one.Y < 0;
  return outside;
}

/// Of all rays at the horizon over flat ground with one pixel 1 m higher.
double rounds_of_the_loop(double side) {
  const int n = static_cast<int>(side);
  lesser::Heights map = lesser::flat(n, 16);
  map.at(0, 0) = 1;
  double rounds = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      rounds += lesser::PrintedMarch(map).from(x, y, {1, 0, 0}).iterations;
  return rounds;
}

}  // namespace

OracleTable lesser2019_march_oracles() {
  return {
      // Column and row of a pixel, of a tower, its height, azimuth and elevation of the sun;
      // whether the pixel is lit, by the listing and by the surface.
      {"lesser2019/lit-behind-a-tower",
       {7,
        [](const Arguments& a) {
          const lesser::Heights map = map_with_tower(a);
          return lit_or_undefined(lesser::PrintedMarch(map)
                                      .from(static_cast<int>(a[0]), static_cast<int>(a[1]),
                                            lesser::listing_9_7({a[6], a[5]}))
                                      .outcome);
        },
        [](const Arguments& a) {
          return lesser::ray(map_with_tower(a), static_cast<int>(a[0]), static_cast<int>(a[1]),
                             lesser::listing_9_7({a[6], a[5]}), lesser::Reading::surface)
                         .lit
                     ? 1.0
                     : 0.0;
        }}},
      // Pixel size, pixels on a side, azimuth of the sun at the horizon, row; whether the first
      // pixel of the row is lit.
      {"lesser2019/ray-over-flat-ground",
       {4, [](const Arguments& a) { return end_over_ground(a, {}); },
        [](const Arguments& a) { return end_over_ground(a, {.unguarded = false}); }}},
      // Column, row, hour of thirteen, pixel size; comparisons at places off the map.
      {"lesser2019/comparisons-off-the-map",
       {4, [](const Arguments& a) { return comparisons_off_the_map(a, true); },
        [](const Arguments& a) { return comparisons_off_the_map(a, false); }}},
      // Pixels on a side, on a smaller one; rounds by the square of the sides, and counted.
      {"lesser2019/rounds-of-the-loop",
       {2, [](const Arguments& a) { return rounds_of_the_loop(a[1]) * std::pow(a[0] / a[1], 2); },
        [](const Arguments& a) { return rounds_of_the_loop(a[0]); }}},
  };
}

}  // namespace phytobench
