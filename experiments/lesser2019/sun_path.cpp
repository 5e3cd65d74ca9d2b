// SPDX-License-Identifier: MIT
// Eq. 8.1, listings 9.7 and 9.11: where the sun stands in each hour.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

double norm_error(const SunDirection& sun) {
  return std::abs(std::sqrt(sun.east * sun.east + sun.south * sun.south + sun.up * sun.up) - 1.0);
}

/// Elevations in tenths of degrees, azimuths in degrees.
void record_directions(ExperimentContext& context) {
  double exact = 0.0, four_decimals = 0.0;
  std::int64_t differences = 0;
  for (int tenths = 0; tenths <= 900; ++tenths)
    for (int azimuth = 0; azimuth <= 360; ++azimuth) {
      const SunDirection sun = direction_of({tenths / 10.0, static_cast<double>(azimuth)});
      exact = std::max(exact, norm_error(sun));
      four_decimals = std::max(four_decimals, norm_error(rounded(sun, 4)));
      if (azimuth % 5 != 0) continue;
      const oracle::Direction listing =
          oracle::listing_9_7({tenths / 10.0, static_cast<double>(azimuth)});
      differences += rounded(sun, 4) != SunDirection{listing.u, listing.v, listing.w};
    }
  context.record("norm-error", exact);
  context.record("rounded-norm-error", four_decimals);
  context.record("rounded-otherwise-than-the-listing", differences, "directions");
  double below = 89.0, zenith = 90.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (below + zenith) / 2.0;
    (in_zenith(rounded(direction_of({middle, 0.0}), 4)) ? zenith : below) = middle;
  }
  context.record("zenith-from", zenith, "degrees");
}

void record_hour(ExperimentContext& context, const std::vector<SunAngles>& path, std::size_t hour) {
  const std::string name = fmt::format("hour-{}/", hour);
  context.record(name + "elevation", path[hour - 1].elevation, "degrees");
  context.record(name + "azimuth", path[hour - 1].azimuth, "degrees");
}

/// Sec. 9.2.3: 13 hours from the horizon in the east to that in the west.
void record_example(ExperimentContext& context) {
  const std::vector<SunAngles> path = sun_angles({.hours = thesis_hours});
  for (const std::size_t hour : {1u, 7u, 13u}) record_hour(context, path, hour);
  context.record("azimuth-step", path[1].azimuth - path[0].azimuth, "degrees");
  context.record("elevation-step", path[1].elevation - path[0].elevation, "degrees");
  const double text = 90.0 / (thesis_hours / 2.0);
  context.record("elevation-step/of-the-text", text, "degrees");
  context.record("elevation-step/noon-by-the-text", 6.0 * text, "degrees");
  const std::vector<SunAngles> gui = sun_angles({.hours = thesis_hours, .max_elevation = 80.0});
  context.record("gui-step", gui[1].elevation - gui[0].elevation, "degrees");
}

/// What follows from both angles in equal steps.
void record_shape(ExperimentContext& context) {
  double viviani = 0.0, rounded_viviani = 0.0, mirror = 0.0;
  std::vector<SunDirection> suns = thesis_path();
  for (std::size_t k = 0; k < suns.size(); ++k) {
    const SunAngles angles = sun_angles({.hours = thesis_hours})[k];
    const auto off = [](const SunDirection& sun) {
      return std::abs(sun.east * sun.east + sun.south * sun.south - std::abs(sun.east));
    };
    viviani = std::max(viviani, off(direction_of(angles)));
    rounded_viviani = std::max(rounded_viviani, off(suns[k]));
    const SunDirection& other = suns[suns.size() - 1 - k];
    for (const double difference :
         {suns[k].east + other.east, suns[k].south - other.south, suns[k].up - other.up})
      mirror = std::max(mirror, std::abs(difference));
  }
  context.record("viviani", viviani);
  context.record("viviani/rounded", rounded_viviani);
  context.record("mirror", mirror);
}

/// Sec. 9.2.3: the last hour is at the start's elevation. Days of 3 to 24 hours.
template <class Path>
void record_days(ExperimentContext& context, const std::string& name, const Path& path) {
  constexpr double start = 10.0, noon = 70.0, rounding = 1e-9;
  std::int64_t returning = 0, reaching = 0;
  for (int hours = 3; hours <= 24; ++hours) {
    const auto angles = path(hours, start, noon);
    double highest = 0.0;
    for (const auto& hour : angles) highest = std::max(highest, hour.elevation);
    returning += std::abs(angles.back().elevation - start) < rounding;
    reaching += std::abs(highest - noon) < rounding;
  }
  context.record("returning-hours/" + name, returning, "days");
  context.record("reaching-hours/" + name, reaching, "days");
}

void record_short_days(ExperimentContext& context) {
  const auto core = [](int hours) {
    return sun_angles(
        {.hours = hours, .start_elevation = 10.0, .start_azimuth = 20.0, .max_elevation = 90.0});
  };
  context.record("one-hour/positions", whole(core(1).size()));
  context.record("one-hour/elevation", core(1)[0].elevation, "degrees");
  context.record("one-hour/azimuth", core(1)[0].azimuth, "degrees");
  context.record("two-hours/last-elevation", core(2)[1].elevation, "degrees");
  context.record("two-hours/last-azimuth", core(2)[1].azimuth, "degrees");
  context.record("three-hours/last-azimuth", core(3)[2].azimuth, "degrees");
  const auto printed = [](int hours, double start_azimuth) {
    return oracle::path({.H = hours, .s0 = 10.0, .a0 = start_azimuth}).back();
  };
  context.record("two-hours/printed/last-elevation", printed(2, 20.0).elevation, "degrees");
  context.record("two-hours/printed/last-azimuth", printed(2, 20.0).azimuth, "degrees");
  context.record("three-hours/printed/last-azimuth", printed(3, 20.0).azimuth, "degrees");
  context.record("two-hours/printed/step-from-azimuth-120", printed(2, 120.0).azimuth - 120.0,
                 "degrees");
}

void run(ExperimentContext& context) {
  record_directions(context);
  record_example(context);
  record_shape(context);
  for (const auto& [name, even] :
       {std::pair("plateau", EvenHours::plateau), std::pair("tent", EvenHours::tent)})
    record_days(context, name, [even = even](int hours, double start, double noon) {
      return sun_angles(
          {.hours = hours, .start_elevation = start, .max_elevation = noon, .even_hours = even});
    });
  for (const auto& [name, loop] : {std::pair("printed", oracle::Loop::half_up),
                                   std::pair("printed-level-noon", oracle::Loop::level_noon)})
    record_days(context, name, [loop = loop](int hours, double start, double noon) {
      return oracle::path({.H = hours, .s0 = start, .M = noon, .loop = loop});
    });
  record_short_days(context);
}

}  // namespace

extern const ExperimentDescriptor sun_path;
constinit const ExperimentDescriptor sun_path{
    .id = "lesser2019/sun-path",
    .question = "Where does the simulated sun stand in each hour?",
    .source = "[Lesser2019] eq. 8.1, sec. 9.2.3, listings 9.7, 9.11",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
