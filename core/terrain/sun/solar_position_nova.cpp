// SPDX-License-Identifier: MIT
// Where the sun stands, from libnova's theory of the Earth's orbit (VSOP87), nutation and sidereal
// time. libnova is seen in this file alone.
#include <libnova/dynamical_time.h>
#include <libnova/nutation.h>
#include <libnova/sidereal_time.h>
#include <libnova/solar.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/sun/solar_position.hpp"

namespace phytobench {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

void check_day(const SolarDay& day) {
  if (!(std::abs(day.latitude) <= 90.0))
    throw InputError(fmt::format("latitude = {} is not between -90 and 90 degrees", day.latitude));
  if (!(std::abs(day.longitude) <= 180.0))
    throw InputError(
        fmt::format("longitude = {} is not between -180 and 180 degrees", day.longitude));
  // Before, how the Earth's rotation is measured against the orbit is not known well enough.
  constexpr int first_year = 1700, last_year = 2300;
  const std::chrono::year_month_day date{std::chrono::year(day.year),
                                         std::chrono::month(static_cast<unsigned int>(day.month)),
                                         std::chrono::day(static_cast<unsigned int>(day.day))};
  const bool fits = day.month >= 1 && day.month <= 12 && day.day >= 1 && day.day <= 31;
  if (!fits || !date.ok() || day.year < first_year || day.year > last_year)
    throw InputError(fmt::format("{}-{:02}-{:02} is no day from {} to {}; give year, month and day",
                                 day.year, day.month, day.day, first_year, last_year));
}

double julian_day(const SolarDay& day, double universal_time) {
  const std::chrono::sys_days date{std::chrono::year(day.year) / day.month / day.day};
  constexpr double julian_day_of_1970 = 2440587.5;
  return julian_day_of_1970 + static_cast<double>(date.time_since_epoch().count()) +
         universal_time / 24.0;
}

/// From the vernal equinox along the ecliptic, as it is seen that day, in degrees; the sun's
/// latitude on the ecliptic of date never exceeds 0.0004 degrees.
double apparent_longitude(double julian_day, const ln_nutation& nutation) {
  const double dynamical = ln_get_jde(julian_day);
  ln_helio_posn sun{};
  ln_get_solar_geom_coords(dynamical, &sun);
  // It counts from the equinox of the year 2000, whatever its name says. General precession: Lieske
  // et al. 1977, Astronomy and Astrophysics 58, in seconds of arc.
  const double centuries = (dynamical - 2451545.0) / 36525.0;
  const double precession = (5029.0966 + 1.11113 * centuries) * centuries / 3600.0;
  constexpr double aberration_degrees = 20.4898 / 3600.0;  // at the mean distance, which R counts
  return sun.L + precession + nutation.longitude - aberration_degrees / sun.R;
}

struct EquatorialPosition {
  double right_ascension = 0.0;  ///< radians
  double declination = 0.0;
};

EquatorialPosition equatorial_position(double julian_day) {
  ln_nutation nutation{};
  ln_get_nutation(julian_day, &nutation);
  const double longitude = apparent_longitude(julian_day, nutation) * degree;
  const double obliquity = (nutation.ecliptic + nutation.obliquity) * degree;
  return {std::atan2(std::sin(longitude) * std::cos(obliquity), std::cos(longitude)),
          std::asin(std::sin(obliquity) * std::sin(longitude))};
}

SunAngles seen_from(const SolarDay& day, double universal_time) {
  const double moment = julian_day(day, universal_time);
  const EquatorialPosition sun = equatorial_position(moment);
  constexpr double degrees_an_hour = 15.0;
  const double sidereal = ln_get_apparent_sidereal_time(moment) * degrees_an_hour;
  const double hour_angle = (sidereal + day.longitude) * degree - sun.right_ascension;
  const double latitude = day.latitude * degree;
  // Unit vector towards the sun: east, north, up.
  const double east = -std::cos(sun.declination) * std::sin(hour_angle);
  const double north = std::sin(sun.declination) * std::cos(latitude) -
                       std::cos(sun.declination) * std::cos(hour_angle) * std::sin(latitude);
  const double up = std::sin(sun.declination) * std::sin(latitude) +
                    std::cos(sun.declination) * std::cos(hour_angle) * std::cos(latitude);
  double azimuth = std::atan2(-north, east) / degree;  // from east over south, -180 to 180
  if (azimuth < -90.0) azimuth += 360.0;               // no jump but in the north
  return {std::atan2(up, std::hypot(east, north)) / degree, azimuth};
}

/// Of the sun's highest stand on that day at that place, in hours of universal time.
double noon(const SolarDay& day) {
  double time = 12.0 - day.longitude / 15.0;
  // Sidereal time and right ascension move with the time; their difference is found at once.
  for (int i = 0; i < 3; ++i) {
    const double moment = julian_day(day, time);
    const double hour_angle = ln_get_apparent_sidereal_time(moment) * 15.0 + day.longitude -
                              equatorial_position(moment).right_ascension / degree;
    time -= std::remainder(hour_angle, 360.0) / 15.0;
  }
  return time;
}

/// When the sun's centre crosses the horizon between a time when it is above and one when it is
/// below; `above` itself if it is not below there either.
double crossing(const SolarDay& day, double above, double below) {
  if (seen_from(day, below).elevation > 0.0) return below;
  // 1e-10 h of 12 are reached after 37 halvings.
  for (int i = 0; i < 40; ++i) {
    const double middle = (above + below) / 2.0;
    (seen_from(day, middle).elevation > 0.0 ? above : below) = middle;
  }
  return (above + below) / 2.0;
}

struct Daylight {
  double sunrise = 0.0;  ///< hours of universal time
  double sunset = 0.0;
};

/// The 24 hours around noon at most; equal times in polar night.
Daylight daylight(const SolarDay& day) {
  const double middle = noon(day);
  if (!(seen_from(day, middle).elevation > 0.0)) return {middle, middle};
  return {crossing(day, middle, middle - 12.0), crossing(day, middle, middle + 12.0)};
}

}  // namespace

bool can_place_the_sun() {
  return true;
}

SunAngles solar_position(const SolarDay& day, double universal_time) {
  check_day(day);
  constexpr double most_hours = 48.0;  // a local day may reach into its neighbours
  if (!(std::abs(universal_time) <= most_hours))
    throw InputError(fmt::format("universal time = {} is no hour of that day", universal_time));
  return seen_from(day, universal_time);
}

std::vector<SunAngles> solar_path(const SolarDay& day, int hours) {
  check_day(day);
  if (hours < 1)
    throw InputError(fmt::format("hours = {} is no number of hours; give at least 1", hours));
  const Daylight light = daylight(day);
  std::vector<SunAngles> path;
  if (light.sunset <= light.sunrise) return path;
  const double step = (light.sunset - light.sunrise) / hours;
  for (int hour = 0; hour < hours; ++hour)
    path.push_back(seen_from(day, light.sunrise + (hour + 0.5) * step));
  return path;
}

double daylight_hours(const SolarDay& day) {
  check_day(day);
  const Daylight light = daylight(day);
  return light.sunset - light.sunrise;
}

}  // namespace phytobench
