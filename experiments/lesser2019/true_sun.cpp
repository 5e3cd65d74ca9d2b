// SPDX-License-Identifier: MIT
// What the simulated path of the sun has in common with a true one: circles of constant
// declination.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/vector3.hpp"
#include "core/terrain/sun/hourly_path.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

constexpr double obliquity = 23.44;  // degrees, of the ecliptic: the sun's greatest declination
constexpr double weissbach = 47.52;  // degrees north: Weissbach bei Lofer, the map of figure 10.7

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}
double degrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

double noon(double latitude, double declination) {
  return oracle::true_noon_elevation(latitude, declination);
}

/// Hours between sunrise and sunset.
double day_length(double latitude, double declination) {
  return degrees(2.0 * std::acos(-std::tan(radians(latitude)) * std::tan(radians(declination)))) /
         15.0;
}

Vector3 true_direction(double latitude, double declination, double hour_angle) {
  const oracle::Direction sun =
      oracle::equation_8_1(oracle::true_sun(latitude, declination, hour_angle));
  return {sun.u, sun.v, sun.w};
}

/// The root mean square distance of points from their best plane: the least eigenvalue of their
/// covariances, by power iteration on what is left of their trace.
double plane_residual(const std::vector<Vector3>& points) {
  Vector3 middle;
  for (const Vector3& point : points) middle = middle + point / static_cast<double>(points.size());
  const auto apply = [&](const Vector3& v) {
    Vector3 sum;
    for (const Vector3& point : points)
      sum = sum + (dot(point - middle, v) / static_cast<double>(points.size())) * (point - middle);
    return sum;
  };
  double trace = 0.0;
  for (const Vector3& point : points)
    trace += dot(point - middle, point - middle) / static_cast<double>(points.size());
  Vector3 normal{0.3, 0.5, 0.7};
  for (int i = 0; i < 2000; ++i) {
    const Vector3 next = trace * normal - apply(normal);
    normal = next / norm(next);
  }
  return std::sqrt(std::max(0.0, dot(normal, apply(normal))));
}

/// How high the sun is in the seventh of 13 hours if that is set as the greatest elevation.
double simulated_noon(double greatest) {
  return sun_angles({.hours = 13, .max_elevation = greatest})[6].elevation;
}

void record_noons(ExperimentContext& context) {
  context.record("noon-june", noon(weissbach, obliquity), "degrees");
  context.record("noon-december", noon(weissbach, -obliquity), "degrees");
  context.record("noon-june/simulated", simulated_noon(noon(weissbach, obliquity)), "degrees");
  context.record("noon-december/simulated", simulated_noon(noon(weissbach, -obliquity)), "degrees");
  context.record("equator/noon-equinox", noon(0.0, 0.0), "degrees");
  context.record("equator/noon-solstice", noon(0.0, obliquity), "degrees");
  context.record("tropic/noon-solstice", noon(obliquity, obliquity), "degrees");
  std::int64_t not_lower = 0, not_lower_in_winter = 0;
  for (int latitude = 1; latitude <= 60; ++latitude) {
    for (const int side : {-1, 1})
      not_lower += noon(side * latitude, 0.0) >= noon(side * (latitude - 1), 0.0);
    if (latitude > obliquity)
      not_lower_in_winter += noon(latitude, -obliquity) >= noon(latitude, obliquity);
  }
  context.record("noons-not-lower-away-from-the-equator", not_lower, "latitudes");
  context.record("noons-not-lower-in-winter", not_lower_in_winter, "latitudes");
}

void record_day_of_thirteen_hours(ExperimentContext& context) {
  // The declination is the latitude, and the day has 13 hours: cos(97.5 degrees) = -tan^2.
  const double latitude = degrees(std::atan(std::sqrt(-std::cos(radians(97.5)))));
  context.record("thirteen-hours/latitude", latitude, "degrees");
  context.record("thirteen-hours/day", day_length(latitude, latitude), "h");
  context.record("thirteen-hours/noon", noon(latitude, latitude), "degrees");
  const double declination =
      degrees(std::atan(-std::cos(radians(97.5)) / std::tan(radians(weissbach))));
  context.record("thirteen-hours/weissbach/noon", noon(weissbach, declination), "degrees");
}

void record_planes(ExperimentContext& context) {
  std::vector<Vector3> simulated;
  for (const SunAngles& angles : sun_angles({.hours = 13})) {
    const SunDirection sun = direction_of(angles);
    simulated.push_back({sun.east, sun.south, sun.up});
  }
  context.record("plane-residual/simulated", plane_residual(simulated));
  double greatest = 0.0;
  for (const double latitude : {0.0, 19.864, weissbach})
    for (const double declination : {-obliquity, 0.0, obliquity}) {
      std::vector<Vector3> path;
      for (int hour = -6; hour <= 6; ++hour)
        path.push_back(true_direction(latitude, declination, 15.0 * hour));
      greatest = std::max(greatest, plane_residual(path));
    }
  context.record("plane-residual/true", greatest);
  // Three hours before noon, the sun in the zenith at noon on the equator: still in the east.
  const Vector3 morning = true_direction(0.0, 0.0, -45.0);
  context.record("equator/south-of-hour-4", std::abs(morning.y));
}

void run(ExperimentContext& context) {
  record_noons(context);
  record_day_of_thirteen_hours(context);
  record_planes(context);
}

}  // namespace

extern const ExperimentDescriptor true_sun;
constinit const ExperimentDescriptor true_sun{
    .id = "lesser2019/true-sun",
    .question = "Is the simulated path of the sun one that the sun takes?",
    .source = "[Lesser2019] sec. 8.2.2, 9.2.3",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
