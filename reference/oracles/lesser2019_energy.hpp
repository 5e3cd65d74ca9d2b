// SPDX-License-Identifier: MIT
// What of the sun's energy a pixel keeps: [Lesser2019] sec. 8.2, listings 9.13 and 9.14. Shares no
// code with core/.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::oracles::lesser2019 {

// 2 cal/cm2 a minute, 20 kcal/m2 a minute.
constexpr double SOLAR_CONSTANT_K_CALORIES_PER_HOUR = 2 * 10000 / 1000 * 60;

struct Losses {
  double cloud_reflection = 0, atmospheric_absorption = 0, atmospheric_diffusion = 0;
};

// Listing 9.13 without its last factor, in its order; in percent.
inline double through_the_air(double raw, const Losses& percent) {
  const double cloud = raw * percent.cloud_reflection / 100;
  const double absorption = raw * percent.atmospheric_absorption / 100;
  const double diffusion = raw * percent.atmospheric_diffusion / 100;
  return raw - cloud - absorption - diffusion;
}

inline double listing_9_13(double raw, const Losses& percent, double albedo) {
  return through_the_air(raw, percent) * (1.0 - albedo);
}

// A lit day on flat ground: as printed, every hour the same (E07), and by the sun's height.
inline double raw_energy_of_flat_ground(const Day& day) {
  return SOLAR_CONSTANT_K_CALORIES_PER_HOUR * day.H;
}
inline double raw_energy_by_height(const Day& day) {
  double sum = 0;
  for (const Angles& sun : path(day))
    sum += SOLAR_CONSTANT_K_CALORIES_PER_HOUR * equation_8_1(sun).w;
  return sum;
}

// A square or oblong image, row by row.
struct Values {
  int n_x = 0, n_y = 0;
  std::vector<double> value;

  double at(int i, int j) const {
    return value[static_cast<std::size_t>(j) * static_cast<std::size_t>(n_x) +
                 static_cast<std::size_t>(i)];
  }
};
inline Values even_values(int n, double value) {
  return {n, n,
          std::vector<double>(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), value)};
}

// What stands around the image in padded_insolation_image; not printed.
enum class Padding { zeros, edge };
// What the sum of the neighbours is divided by: the listing's 8, or their number (E12).
enum class Divisor { eight, number_of_neighbours };

// Around (i, j): the mean of `value(i, j)` that listing 9.14 adds a part of. NaN counts as padding.
template <class Value>
double mean_around(int n_x, int n_y, int i, int j, Padding padding, Divisor divisor,
                   const Value& value) {
  double sum = 0;
  int there = 0;
  const int di[8] = {1, 1, 0, -1, -1, -1, 0, 1}, dj[8] = {0, 1, 1, 1, 0, -1, -1, -1};
  for (int k = 0; k < 8; ++k) {
    int x = i + di[k], y = j + dj[k];
    const bool is_outside = x < 0 || y < 0 || x >= n_x || y >= n_y;
    if (is_outside && padding == Padding::zeros) continue;
    x = x < 0 ? 0 : (x >= n_x ? n_x - 1 : x);
    y = y < 0 ? 0 : (y >= n_y ? n_y - 1 : y);
    if (std::isnan(value(x, y))) continue;
    sum += value(x, y);
    there += !is_outside;
  }
  if (divisor == Divisor::eight) return sum / 8;
  return there == 0 ? 0 : sum / there;
}

// Listing 9.14: from a copy, so that no order of pixels matters. `energy` has the albedo taken off.
inline Values listing_9_14(const Values& energy, double reflection_coefficient,
                           Padding padding = Padding::zeros, Divisor divisor = Divisor::eight) {
  Values result = energy;
  std::size_t k = 0;
  for (int j = 0; j < energy.n_y; ++j)
    for (int i = 0; i < energy.n_x; ++i)
      result.value[k++] += mean_around(energy.n_x, energy.n_y, i, j, padding, divisor,
                                       [&](int x, int y) { return energy.at(x, y); }) *
                           reflection_coefficient;
  return result;
}

// What of the reflected light a pixel keeps that gets it.
enum class Received { partly_reflected_again, all };

// Corrected (E13): what is handed on is what neighbours reflect, albedo times what reaches them.
// `incident` is before the albedo.
inline Values reflected_by_albedo(const Values& incident, const Values& albedo,
                                  double reflection_coefficient,
                                  Received received = Received::partly_reflected_again,
                                  Divisor divisor = Divisor::number_of_neighbours) {
  Values result = incident;
  std::size_t k = 0;
  for (int j = 0; j < incident.n_y; ++j)
    for (int i = 0; i < incident.n_x; ++i) {
      const double kept = 1 - albedo.at(i, j);
      const double more =
          mean_around(incident.n_x, incident.n_y, i, j, Padding::zeros, divisor,
                      [&](int x, int y) { return albedo.at(x, y) * incident.at(x, y); }) *
          reflection_coefficient;
      result.value[k++] = kept * incident.at(i, j) +
                          (received == Received::partly_reflected_again ? kept * more : more);
    }
  return result;
}

}  // namespace phytobench::oracles::lesser2019
