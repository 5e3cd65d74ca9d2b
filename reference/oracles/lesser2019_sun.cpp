// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_sun.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace phytobench::oracles::lesser2019 {

namespace {

constexpr double pi = 3.14159265358979323846;

double radians(double degrees) {
  return degrees * (pi / 180.0);
}

double degrees(double radians_) {
  return radians_ * (180.0 / pi);
}

double listing_9_11_elevation(const Day& day) {
  if (day.H == 1) return 0;
  if (day.H == 2) return day.M - day.s0;
  if (day.H % 2 == 1) return (day.M - day.s0) / std::ceil((day.H - 2) / 2.0);
  return (day.M - day.s0) / (day.H / 2.0);
}

// The way of the elevation for even hours from steps up and down: how many steps the hour k (from
// 0) is above the start.
int steps_up(const Day& day, int k) {
  const bool level = day.loop == Loop::level_noon || day.elevation == ElevationStep::one_formula ||
                     day.elevation == ElevationStep::tent;
  if (level) return std::min(k, day.H - 1 - k);
  return k <= day.H / 2 ? k : 2 * (day.H / 2) - k;
}

}  // namespace

double elevation_per_hour(const Day& day) {
  if (day.H == 1) return 0;
  switch (day.elevation) {
    case ElevationStep::listing:
      return listing_9_11_elevation(day);
    case ElevationStep::text:
      return (day.M - day.s0) / (day.H / 2.0);
    case ElevationStep::one_formula:
      // Two hours have the start on both sides of noon.
      return day.H == 2 ? 0 : (day.M - day.s0) / std::ceil((day.H - 2) / 2.0);
    case ElevationStep::tent:
      return (day.M - day.s0) / ((day.H - 1) / 2.0);
  }
  return 0;
}

double azimuth_per_hour(const Day& day) {
  if (day.H == 1) return 0;
  if (day.H == 2 && day.azimuth == AzimuthStep::listing) return 180 - 2 * day.a0;
  return 180.0 / (day.H - 1);
}

std::vector<Angles> path(const Day& day) {
  const double up = elevation_per_hour(day), on = azimuth_per_hour(day);
  std::vector<Angles> hours;
  for (int k = 0; k < day.H; ++k)
    hours.push_back({day.s0 + up * steps_up(day, k), day.a0 + on * k});
  return hours;
}

Direction equation_8_1(const Angles& sun) {
  const double el = radians(sun.elevation), az = radians(sun.azimuth);
  return {std::cos(az) * std::cos(el), std::sin(az) * std::cos(el), std::sin(el)};
}

double rounded_to_four(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4f", value);
  return std::strtod(text, nullptr);
}

Direction listing_9_7(const Angles& sun) {
  const Direction d = equation_8_1(sun);
  return {rounded_to_four(d.u), rounded_to_four(d.v), rounded_to_four(d.w)};
}

std::vector<Direction> directions(const Day& day) {
  std::vector<Direction> suns;
  for (const Angles& sun : path(day)) suns.push_back(listing_9_7(sun));
  return suns;
}

Angles true_sun(double latitude, double declination, double hour_angle) {
  const double phi = radians(latitude), delta = radians(declination), h = radians(hour_angle);
  const double east = -std::cos(delta) * std::sin(h);
  const double south =
      std::sin(phi) * std::cos(delta) * std::cos(h) - std::cos(phi) * std::sin(delta);
  const double up = std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::cos(h);
  return {degrees(std::asin(std::clamp(up, -1.0, 1.0))), degrees(std::atan2(south, east))};
}

double true_noon_elevation(double latitude, double declination) {
  return 90 - std::abs(latitude - declination);
}

double top_of_atmosphere(double latitude, double declination, double solar_constant) {
  const double phi = radians(latitude), delta = radians(declination);
  const double h0 = std::acos(std::clamp(-std::tan(phi) * std::tan(delta), -1.0, 1.0));
  const double joules =
      solar_constant * 86400 / pi *
      (h0 * std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::sin(h0));
  return joules / 4184;
}

}  // namespace phytobench::oracles::lesser2019
