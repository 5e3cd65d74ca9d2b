// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/oracles/lesser2019_relief.hpp"

namespace phytobench {

namespace {

namespace lesser = oracles::lesser2019;

/// Energy, share, column and row of a flat map of 5 x 5 pixels.
double energy_of_five(const Arguments& a, lesser::Divisor divisor) {
  return lesser::listing_9_14(lesser::even_values(5, a[0]), a[1], lesser::Padding::zeros, divisor)
      .at(static_cast<int>(a[2]), static_cast<int>(a[3]));
}

lesser::Heights needle_of(double height, double ps) {
  lesser::Heights map = lesser::flat(3, ps);
  map.at(1, 1) = height;
  return map;
}

OracleTable energy_oracles() {
  return {
      {"lesser2019/energy-at-a-border",
       {4, [](const Arguments& a) { return energy_of_five(a, lesser::Divisor::eight); },
        [](const Arguments& a) {
          return energy_of_five(a, lesser::Divisor::number_of_neighbours);
        }}},
      // What reaches flat ground, its albedo, share for neighbours; what it keeps.
      {"lesser2019/energy-kept-by-flat-ground",
       {3,
        [](const Arguments& a) {
          return lesser::listing_9_14(lesser::even_values(3, a[0] * (1 - a[1])), a[2]).at(1, 1);
        },
        [](const Arguments& a) {
          return lesser::reflected_by_albedo(lesser::even_values(3, a[0]),
                                             lesser::even_values(3, a[1]), a[2])
              .at(1, 1);
        }}},
      // Energy, absorption, diffusion, clouds in percent, albedo; with shares instead, and as the
      // listings have them.
      {"lesser2019/energy-with-losses-as-described",
       {5,
        [](const Arguments& a) {
          return lesser::listing_9_13(a[0], {a[3] / 100, a[1] / 100, a[2] / 100}, a[4]);
        },
        [](const Arguments& a) {
          return lesser::listing_9_13(a[0], {a[3], a[1], a[2]}, a[4]);
        }}},
      // Energy, clouds, absorption, diffusion, albedo.
      {"lesser2019/energy-under-heavy-losses",
       {5,
        [](const Arguments& a) {
          return lesser::listing_9_13(a[0], {a[1], a[2], a[3]}, a[4]);
        },
        [](const Arguments& a) {
          return std::max(0.0, lesser::listing_9_13(a[0], {a[1], a[2], a[3]}, a[4]));
        }}},
      // Refractive index; share of the light of an even sky.
      {"lesser2019/albedo-of-water",
       {1, [](const Arguments&) { return 0.5; },  // fig. 4.6
        [](const Arguments& a) { return lesser::diffuse_fresnel(a[0]); }}},
  };
}

OracleTable soil_and_water_oracles() {
  return {
      {"lesser2019/heat-of-evaporation",
       {2, [](const Arguments&) { return lesser::PRINTED_KCAL_PER_ML; },
        [](const Arguments& a) { return lesser::kcal_per_ml(a[0], a[1]); }}},
      // Slope, greatest depth; depth with the cosine of the slope as the angle, and with the angle.
      {"lesser2019/soil-depth-on-a-slope",
       {2,
        [](const Arguments& a) {
          const double slope = a[0] * 3.14159265358979323846 / 180;
          const lesser::Normal n{std::sin(slope), 0, std::cos(slope)};
          return lesser::listing_9_15(lesser::dot_with_vertical(n), a[1]);
        },
        [](const Arguments& a) { return lesser::listing_9_15(a[0], a[1]); }}},
      // kcal/m2, kcal/ml; litres.
      {"lesser2019/litres-evaporated",
       {2,
        [](const Arguments& a) {
          return lesser::evaporated_litres(a[0], a[1], lesser::Evaporation::multiplied);
        },
        [](const Arguments& a) {
          return lesser::evaporated_litres(a[0], a[1], lesser::Evaporation::divided);
        }}},
      // Height of a needle, pixel size; slope by six faces and by the steepest edge.
      {"lesser2019/slope-of-a-needle",
       {2,
        [](const Arguments& a) {
          return lesser::angle_to_vertical(
              lesser::normal_of_six_faces(needle_of(a[0], a[1]), 1, 1));
        },
        [](const Arguments& a) { return lesser::steepest_edge(needle_of(a[0], a[1]), 1, 1); }}},
      // l/cm2, and l/m2.
      {"lesser2019/water-demand-of-a-square-metre",
       {1, [](const Arguments& a) { return a[0] * 100 * 100; },
        [](const Arguments& a) { return a[0]; }}},
  };
}

OracleTable chance_oracles() {
  return {
      // Needed, available.
      {"lesser2019/chance-without-need",
       {2, [](const Arguments& a) { return lesser::listing_9_17(a[0], a[1]); },
        [](const Arguments& a) { return a[0] == 0 ? 1.0 : lesser::listing_9_17(a[0], a[1]); }}},
      {"lesser2019/chance-beyond-twice-the-need",
       {2, [](const Arguments& a) { return 1 - (a[1] / a[0] - 1); },  // sec. 8.6
        [](const Arguments& a) { return lesser::listing_9_17(a[0], a[1]); }}},
      // Depth needed, available.
      {"lesser2019/chance-by-soil-depth",
       {2,
        [](const Arguments& a) {
          return lesser::depth_chance(a[0], a[1], lesser::DepthRule::triangle);
        },
        [](const Arguments& a) {
          return lesser::depth_chance(a[0], a[1], lesser::DepthRule::saturating);
        }}},
  };
}

}  // namespace

OracleTable lesser2019_ground_oracles() {
  OracleTable all = energy_oracles();
  all.merge(soil_and_water_oracles());
  all.merge(chance_oracles());
  return all;
}

}  // namespace phytobench
