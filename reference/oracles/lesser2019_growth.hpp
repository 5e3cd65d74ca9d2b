// SPDX-License-Identifier: MIT
// Water and chances to grow: [Lesser2019] sec. 8.5, 8.6, listings 9.16 and 9.17; images that are
// saved and loaded again, listing 9.8; what a reflecting surface of water does. Shares no code with
// core/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace phytobench::oracles::lesser2019 {

// kcal/ml: the printed product of sec. 8.5 (E01), and what its factors give.
constexpr double PRINTED_KCAL_PER_ML = 0.54;
constexpr double kcal_per_ml(double joule_per_gram, double kcal_per_joule) {
  return joule_per_gram * kcal_per_joule;
}

// How energy becomes litres of vapour.
enum class Evaporation {
  multiplied,  // listing 9.16 (E16)
  divided,
};

constexpr double evaporated_litres(double kcal, double kcal_for_1_ml, Evaporation how) {
  return (how == Evaporation::multiplied ? kcal * kcal_for_1_ml : kcal / kcal_for_1_ml) / 1000;
}

struct Ground {
  double depth = 0;                                  // cm
  double water_absorption = 1;                       // of the soil
  double groundwater = 0, avg_rainfall_per_day = 0;  // l
};

constexpr double water_supply(const Ground& ground) {
  const double depth_coefficient = ground.depth >= 100 ? 1.0 : ground.depth / 100;
  return (ground.groundwater + ground.avg_rainfall_per_day) * depth_coefficient *
         ground.water_absorption;
}

// Listing 9.16: litres that are left.
constexpr double listing_9_16(const Ground& ground, double kcal,
                              double kcal_for_1_ml = PRINTED_KCAL_PER_ML,
                              Evaporation how = Evaporation::multiplied) {
  const double supply = water_supply(ground);
  double evaporated_water = evaporated_litres(kcal, kcal_for_1_ml, how);
  if (evaporated_water > supply) evaporated_water = supply;
  return supply - evaporated_water;
}

// Listing 9.17. NaN where the program divides by zero.
inline double listing_9_17(double needed, double available) {
  if (available <= needed) {
    if (needed == 0) return std::numeric_limits<double>::quiet_NaN();
    return available / needed;
  }
  if (available <= needed * 2) return 1 - (available / needed - 1);
  return 0;
}

// The chance by the soil's depth: sec. 8.6 exempts only the kind of soil from the triangle; the
// best places are the deepest ones in sec. 10.4.
enum class DepthRule { triangle, saturating, threshold, ignored };
inline double depth_chance(double needed, double available, DepthRule rule) {
  switch (rule) {
    case DepthRule::triangle:
      return listing_9_17(needed, available);
    case DepthRule::saturating:
      return available >= needed ? 1 : available / needed;
    case DepthRule::threshold:
      return available >= needed ? 1 : 0;
    case DepthRule::ignored:
      break;
  }
  return 1;
}

// Sec. 8.6: the law of the minimum.
inline double least_chance(const std::vector<double>& chances) {
  double least = 1;
  for (const double chance : chances)
    if (chance < least) least = chance;
  return least;
}

// Listing 9.8. The 16 bits of a pixel: the cast cuts off (E22), and what does not fit wraps around
// (E23), as it does on usual machines; written out, as C++ would leave it undefined.
inline std::uint16_t saved_pixel(double value) {
  const double code = std::fmod(std::trunc(value * 1000), 65536.0);
  return static_cast<std::uint16_t>(code < 0 ? code + 65536.0 : code);
}
inline double loaded_pixel(std::uint16_t code) {
  return code / 1000.0;
}
inline double reloaded(double value) {
  return loaded_pixel(saved_pixel(value));
}
// The faults one by one: cut off but not wrapped, wrapped but rounded.
inline double reloaded_without_wrap(double value) {
  return std::trunc(value * 1000) / 1000.0;
}
inline double reloaded_rounded(double value) {
  return std::fmod(std::round(value * 1000), 65536.0) / 1000.0;
}

// Not in the thesis: the share of unpolarised light that a surface of water reflects (Fresnel), at
// an angle from the vertical in radians, and averaged over a sky of even brightness.
inline double fresnel(double angle, double refractive_index) {
  if (angle == 0) return std::pow((refractive_index - 1) / (refractive_index + 1), 2);
  const double inside = std::asin(std::sin(angle) / refractive_index);
  const double s = std::sin(angle - inside) / std::sin(angle + inside);
  const double p = std::tan(angle - inside) / std::tan(angle + inside);
  return (s * s + p * p) / 2;
}
inline double diffuse_fresnel(double refractive_index) {
  constexpr int parts = 20000;
  constexpr double right_angle = 1.57079632679489661923;
  double sum = 0;
  for (int k = 0; k < parts; ++k) {
    const double angle = (k + 0.5) / parts * right_angle;
    sum += fresnel(angle, refractive_index) * std::sin(2 * angle);
  }
  return sum / parts * right_angle;
}

}  // namespace phytobench::oracles::lesser2019
