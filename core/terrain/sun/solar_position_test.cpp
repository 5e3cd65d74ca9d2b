// SPDX-License-Identifier: MIT
#include "core/terrain/sun/solar_position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

constexpr double radians = std::numbers::pi / 180.0;

/// From north over east, as most count.
double from_north(const SunAngles& sun) {
  return std::fmod(sun.azimuth + 90.0 + 360.0, 360.0);
}

/// How far apart two directions are, in degrees.
double angle_between(const SunAngles& a, const SunAngles& b) {
  const SunDirection u = direction_of(a), v = direction_of(b);
  const double chord = std::hypot(u.east - v.east, u.south - v.south, u.up - v.up);
  return 2.0 * std::asin(chord / 2.0) / radians;
}

/// What the air lifts the sun by, in degrees (Reda and Andreas 2004, Solar Energy 76, eq. 42), for
/// mbar and degrees Celsius.
double refraction(double elevation, double pressure, double temperature) {
  return pressure / 1010.0 * 283.0 / (273.0 + temperature) * 1.02 /
         (60.0 * std::tan((elevation + 10.3 / (elevation + 5.11)) * radians));
}

// The example of Reda and Andreas 2004, table A5.1: 17 October 2003, 12:30:30 at UTC-7, near
// Golden. Its zenith angle of 50.11162 degrees is seen from the Earth's surface, which lowers the
// sun by up to 8.794 seconds of arc (parallax), through air of 820 mbar and 11 degrees, which lifts
// it by a sixtieth of a degree. Both are no part of where the sun's centre stands as seen from the
// Earth's, and are put in here by that work's own formulas: what then is left is the difference
// of two theories of the orbit.
TEST(SolarPosition, AgreesWithThePublishedReference) {
  const SolarDay day{
      .latitude = 39.742476, .longitude = -105.1786, .year = 2003, .month = 10, .day = 17};
  const SunAngles sun = solar_position(day, 19.0 + 30.5 / 60.0);
  const double parallax = 8.794 / 3600.0 / 0.9965422974 * std::cos(sun.elevation * radians);
  const double lowered = sun.elevation - parallax;
  const double seen = lowered + refraction(lowered, 820.0, 11.0);
  EXPECT_NEAR(90.0 - seen, 50.11162, 0.001);
  EXPECT_NEAR(from_north(sun), 194.34024, 0.001);
  // What solar_position() promises by itself: the reference without refraction, which it gives as
  // 0.016332 degrees.
  EXPECT_NEAR(90.0 - sun.elevation, 50.11162 + 0.016332, 0.01);
}

TEST(SolarPosition, StandsInTheSouthAtNoonAndInTheNorthSouthOfTheEquator) {
  const SolarDay weissbach{.latitude = 47.52, .longitude = 12.75, .month = 6, .day = 21};
  const double noon = 12.0 - 12.75 / 15.0;  // within minutes
  EXPECT_NEAR(solar_position(weissbach, noon).azimuth, 90.0, 3.0);
  EXPECT_NEAR(solar_position(weissbach, noon - 6.0).azimuth, -18.0, 5.0) << "north of east";
  EXPECT_NEAR(solar_position(weissbach, noon + 6.0).azimuth, 198.0, 5.0) << "north of west";
  SolarDay south = weissbach;
  south.latitude = -47.52;
  south.month = 12;
  EXPECT_NEAR(std::abs(std::remainder(solar_position(south, noon).azimuth - 270.0, 360.0)), 0.0,
              3.0);
}

double greatest_elevation(const SolarDay& day) {
  double greatest = -90.0;
  for (const SunAngles& sun : solar_path(day, 401)) greatest = std::max(greatest, sun.elevation);
  return greatest;
}

// 90 - |latitude - declination|, with the declination of the solstices, 23.436 degrees in 2019.
TEST(SolarPosition, NoonOfTheSolsticesFollowsFromTheLatitude) {
  const auto day = [](double latitude, int month) {
    return SolarDay{
        .latitude = latitude, .year = 2019, .month = month, .day = month == 6 ? 21 : 22};
  };
  // The date's noon is up to half a day off the solstice: declination changes by 0.001 degrees.
  constexpr double tolerance = 0.003;
  EXPECT_NEAR(greatest_elevation(day(47.52, 6)), 90.0 - 47.52 + 23.436, tolerance);
  EXPECT_NEAR(greatest_elevation(day(47.52, 12)), 90.0 - 47.52 - 23.436, tolerance);
  EXPECT_NEAR(greatest_elevation(day(0.0, 6)), 90.0 - 23.436, tolerance);
  EXPECT_NEAR(greatest_elevation(day(23.436, 6)), 90.0, 0.1) << "steps of a day's path";
}

// Day length of a declination d: 24 h acos(-tan latitude tan d) / pi; d from noon's elevation. The
// declination moves during the day by up to 0.4 degrees, and the solar day is up to 30 s off 24 h.
TEST(SolarPosition, DayLengthFollowsFromLatitudeAndDeclination) {
  for (const double latitude : {-60.0, -33.0, 0.0, 19.864, 47.52, 60.0})
    for (const int month : {1, 3, 4, 6, 9, 12}) {
      const SolarDay day{.latitude = latitude, .longitude = 30.0, .month = month, .day = 21};
      const std::vector<SunAngles> path = solar_path(day, 301);
      const SunAngles noon = *std::max_element(
          path.begin(), path.end(),
          [](const SunAngles& a, const SunAngles& b) { return a.elevation < b.elevation; });
      const bool is_in_the_south = noon.azimuth > 0.0 && noon.azimuth < 180.0;
      const double from_zenith = 90.0 - noon.elevation;
      const double declination = latitude + (is_in_the_south ? -from_zenith : from_zenith);
      const double hours =
          24.0 / std::numbers::pi *
          std::acos(-std::tan(latitude * radians) * std::tan(declination * radians));
      EXPECT_NEAR(daylight_hours(day), hours, 0.03) << latitude << " in month " << month;
    }
}

// Where the day has 13 hours and the sun passes the zenith: tan(latitude)^2 = -cos(97.5 degrees),
// latitude and declination 19.864 degrees, reached on 20 May and 23 July.
TEST(SolarPosition, ThirteenHoursAndTheZenithGoTogetherAtOneLatitude) {
  const double latitude = std::atan(std::sqrt(-std::cos(97.5 * radians))) / radians;
  EXPECT_NEAR(latitude, 19.864, 0.0005);
  double closest = 90.0, hours = 0.0;
  for (const int day : {18, 19, 20, 21, 22}) {
    const SolarDay date{.latitude = latitude, .year = 2019, .month = 5, .day = day};
    const double from_zenith = 90.0 - greatest_elevation(date);
    if (from_zenith < closest) {
      closest = from_zenith;
      hours = daylight_hours(date);
    }
  }
  // The declination moves by 0.2 degrees from one day to the next.
  EXPECT_LT(closest, 0.15);
  EXPECT_NEAR(hours, 13.0, 0.01);
}

TEST(SolarPosition, DaysOfTheEquinoxHaveTwelveHours) {
  for (const double latitude : {-50.0, 0.0, 50.0}) {
    const SolarDay day{.latitude = latitude, .year = 2019, .month = 3, .day = 21};
    // The equinox was at 22 h on the 20th: 0.3 degrees of declination are 3 minutes at 50 degrees.
    EXPECT_NEAR(daylight_hours(day), 12.0, 0.06) << latitude;
  }
}

TEST(SolarPath, GoesFromSunriseToSunsetAtTheMiddlesOfEqualSteps) {
  const SolarDay day{.latitude = 47.52, .longitude = 12.75, .month = 4, .day = 1};
  const std::vector<SunAngles> path = solar_path(day, 12);
  ASSERT_EQ(path.size(), 12u);
  for (const SunAngles& sun : path) EXPECT_GT(sun.elevation, 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GT(path[i].azimuth, path[i - 1].azimuth);
  // Morning and evening are alike but for the day's change of declination, 0.2 degrees.
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(path[i].elevation, path[11 - i].elevation, 0.4);
    EXPECT_NEAR(path[i].azimuth, 180.0 - path[11 - i].azimuth, 0.6);
  }
  // Half a step after sunrise, at the rate that the sun has there when the day has 12 hours.
  const double step = daylight_hours(day) / 12.0;
  EXPECT_NEAR(path.front().elevation, 15.0 * step / 2.0 * std::cos(47.52 * radians), 0.5);
  EXPECT_LT(angle_between(solar_path(day, 1)[0], solar_path(day, 3)[1]), 1e-6);
}

TEST(SolarPath, KnowsPolarDayAndPolarNight) {
  SolarDay day{.latitude = 78.0, .longitude = 15.0, .month = 6, .day = 21};
  EXPECT_DOUBLE_EQ(daylight_hours(day), 24.0);
  const std::vector<SunAngles> path = solar_path(day, 24);
  ASSERT_EQ(path.size(), 24u);
  for (const SunAngles& sun : path) EXPECT_GT(sun.elevation, 11.0);
  day.month = 12;
  EXPECT_EQ(daylight_hours(day), 0.0);
  EXPECT_TRUE(solar_path(day, 24).empty());
}

TEST(SolarPath, IsFoundAtTheDateLineAndAtThePoles) {
  for (const double longitude : {-180.0, 180.0}) {
    const SolarDay day{.latitude = 10.0, .longitude = longitude, .month = 2, .day = 1};
    EXPECT_NEAR(daylight_hours(day), 11.6, 0.2) << longitude;
  }
  for (const double latitude : {-90.0, 90.0}) {
    const SolarDay day{.latitude = latitude, .month = 6, .day = 21};
    EXPECT_DOUBLE_EQ(daylight_hours(day), latitude > 0.0 ? 24.0 : 0.0);
  }
}

std::string solar_refusal(const SolarDay& day, int hours = 12) {
  try {
    solar_path(day, hours);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SolarPosition, RefusesDaysAndPlacesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(solar_refusal({.latitude = 90.5}), HasSubstr("latitude = 90.5"));
  EXPECT_THAT(solar_refusal({.latitude = nan}), HasSubstr("latitude = nan"));
  EXPECT_THAT(solar_refusal({.longitude = 181.0}), HasSubstr("longitude = 181"));
  EXPECT_THAT(solar_refusal({.year = 2019, .month = 2, .day = 29}), HasSubstr("2019-02-29"));
  EXPECT_EQ(solar_refusal({.year = 2020, .month = 2, .day = 29}), "no error");
  EXPECT_THAT(solar_refusal({.month = 13}), HasSubstr("2019-13-21"));
  EXPECT_THAT(solar_refusal({.month = -1}), HasSubstr("is no day"));
  EXPECT_THAT(solar_refusal({.day = 0}), HasSubstr("2019-06-00"));
  EXPECT_THAT(solar_refusal({.day = 300}), HasSubstr("is no day"));
  EXPECT_THAT(solar_refusal({.year = 1200}), HasSubstr("1200-06-21"));
  EXPECT_THAT(solar_refusal({}, 0), HasSubstr("hours = 0"));
  EXPECT_THROW(solar_position({}, nan), InputError);
  EXPECT_THROW(solar_position({}, 1e9), InputError);
}

}  // namespace
}  // namespace phytobench
