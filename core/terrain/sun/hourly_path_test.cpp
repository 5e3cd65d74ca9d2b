// SPDX-License-Identifier: MIT
#include "core/terrain/sun/hourly_path.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(HourlyPath, ThirteenHoursGoOverTheZenith) {  // [Lesser2019] sec. 9.2.3
  const std::vector<SunAngles> path = sun_angles({});
  ASSERT_EQ(path.size(), 13u);
  for (int k = 0; k < 13; ++k) {
    EXPECT_EQ(path[static_cast<std::size_t>(k)].elevation, 15.0 * std::min(k, 12 - k));
    EXPECT_EQ(path[static_cast<std::size_t>(k)].azimuth, 15.0 * k);
  }
  EXPECT_EQ(direction_of(path[0]), (SunDirection{1.0, 0.0, 0.0}));
  EXPECT_EQ(direction_of(path[6]), (SunDirection{0.0, 0.0, 1.0}));
  EXPECT_TRUE(in_zenith(direction_of(path[6])));
}

// The thesis' own step for even hours misses the start, or the greatest elevation.
TEST(HourlyPath, ReturnsToTheStartForAnyNumberOfHours) {
  for (const EvenHours even : {EvenHours::plateau, EvenHours::tent})
    for (int hours = 1; hours <= 24; ++hours) {
      const auto path = sun_angles({hours, 10.0, 0.0, 70.0, even});
      EXPECT_EQ(path.front().elevation, 10.0) << hours;
      EXPECT_NEAR(path.back().elevation, 10.0, 1e-12) << hours;
      EXPECT_EQ(path.back().azimuth, hours == 1 ? 0.0 : 180.0) << hours;
    }
}

TEST(HourlyPath, EvenHoursHaveAPlateauOrNoNoon) {
  const auto plateau = sun_angles({.hours = 12});
  EXPECT_EQ(plateau[5].elevation, 90.0);
  EXPECT_EQ(plateau[6].elevation, 90.0);
  EXPECT_EQ(plateau[1].elevation, 18.0);
  const auto tent = sun_angles({.hours = 12, .even_hours = EvenHours::tent});
  EXPECT_NEAR(tent[5].elevation, 90.0 * 10.0 / 11.0, 1e-12);
  EXPECT_NEAR(tent[1].elevation, 90.0 * 2.0 / 11.0, 1e-12);
}

TEST(HourlyPath, InOddHoursBothAreTheSame) {
  const auto a = sun_angles({.hours = 9}), b = sun_angles({9, 0, 0, 90, EvenHours::tent});
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(a[k].elevation, b[k].elevation, 1e-12);
}

TEST(SunDirectionLaw, IsAUnitVectorUntilRounded) {  // [Lesser2019] eq. 8.1, listing 9.7
  double worst = 0.0, worst_rounded = 0.0;
  for (int elevation = 0; elevation <= 900; ++elevation)
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
      const SunDirection sun = direction_of({elevation / 10.0, static_cast<double>(azimuth)});
      const SunDirection cut = rounded(sun, 4);
      worst = std::max(worst, std::abs(std::hypot(sun.east, sun.south, sun.up) - 1.0));
      worst_rounded =
          std::max(worst_rounded, std::abs(std::hypot(cut.east, cut.south, cut.up) - 1.0));
    }
  EXPECT_LE(worst, 1e-15);
  EXPECT_LE(worst_rounded, std::sqrt(3.0) * 5e-5);
  EXPECT_GT(worst_rounded, 8e-5);
}

TEST(SunDirectionLaw, MorningMirrorsEvening) {
  const auto path = sun_angles({});
  for (std::size_t k = 0; k < 6; ++k) {
    const SunDirection a = rounded(direction_of(path[k]), 4),
                       b = rounded(direction_of(path[12 - k]), 4);
    EXPECT_EQ(a.east, -b.east);
    EXPECT_EQ(a.south, b.south);
    EXPECT_EQ(a.up, b.up);
  }
}

}  // namespace
}  // namespace phytobench
