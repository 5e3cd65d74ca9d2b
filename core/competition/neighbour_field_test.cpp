// SPDX-License-Identifier: MIT
#include "core/competition/neighbour_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// The field over a disc, on rings around the disc's own center.
double by_rings(const NeighbourField& field, double radius, double distance) {
  constexpr int rings = 400, angles = 400;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double r = radius * (i + 0.5) / rings;
    for (int k = 0; k < angles; ++k) {
      const double phi = std::numbers::pi * (k + 0.5) / angles;
      sum += r * field.at(std::hypot(distance + r * std::cos(phi), r * std::sin(phi)));
    }
  }
  return sum * (radius / rings) * (2.0 * std::numbers::pi / angles);
}

TEST(NeighbourFieldLaw, FallsFromTheStemToTheRim) {
  const NeighbourField field(0.2, 2.0, 0.1);
  EXPECT_EQ(field.at(0.1), 1.0);
  EXPECT_EQ(field.at(0.2), 1.0);
  EXPECT_NEAR(field.at(2.0), 0.1, 1e-15);
  EXPECT_EQ(field.at(2.0001), 0.0);
  EXPECT_NEAR(field.at(1.1) * field.at(1.1), field.at(0.2) * field.at(2.0), 1e-15);
}

TEST(NeighbourFieldLaw, HasTheKnownIntegral) {
  const double stem = 0.2332910271565309;
  EXPECT_NEAR(NeighbourField(stem, 10 * stem, 0.1).over_own_disc(10 * stem), 4.872866190117051,
              1e-13);
}

TEST(NeighbourFieldLaw, DiscsThatHoldTheFieldHaveAllOfIt) {
  const NeighbourField field(0.2, 2.0, 0.1);
  EXPECT_NEAR(field.over_disc(3.0, 0.5), field.over_own_disc(2.0), 1e-12);
  EXPECT_NEAR(field.over_disc(2.0, 0.0), field.over_own_disc(2.0), 1e-12);
  EXPECT_EQ(field.over_disc(1.0, 3.0), 0.0);
}

TEST(NeighbourFieldLaw, IsContinuousWhereTheFormChanges) {
  const NeighbourField field(0.2, 2.0, 0.1);
  for (const double distance : {1e-12, 0.3, 0.5, 0.7, 1.5, 2.499999})
    EXPECT_NEAR(field.over_disc(0.5, distance), field.over_disc(0.5, distance + 1e-12), 1e-10);
}

/// A disc worlds larger than the field, and nearly a half plane where its border crosses the field:
/// against thin rings around the stem, each with the share of it inside the disc.
TEST(NeighbourFieldOracle, IsRightForDiscsMuchLargerThanTheField) {
  const double stem = 0.05, zone = 1.0;
  const NeighbourField field(stem, zone, 0.1);
  for (const double radius : {0.7, 2.0, 5.0, 20.0, 100.0, 1000.0})
    for (const double in_reach : {0.9, 0.5, 0.01, -0.3, -0.6}) {
      const double distance = radius + in_reach * zone;
      constexpr int rings = 400'000;
      double sum = 0.0;
      for (int k = 0; k < rings; ++k) {
        const double r = zone * (k + 0.5) / rings;
        const double cosine =
            ((r - radius) * (r + radius) + distance * distance) / (2.0 * r * distance);
        sum += 2.0 * r * std::acos(std::clamp(cosine, -1.0, 1.0)) * field.at(r);
      }
      const double expected = sum * zone / rings;
      EXPECT_NEAR(field.over_disc(radius, distance) / expected, 1.0, 2e-6)
          << radius << " " << in_reach;
    }
}

TEST(NeighbourFieldLaw, FlatFieldsAreTheAreaOfTheZone) {
  for (const double below_one : {1e-3, 1e-8, 1e-14}) {
    const double whole = NeighbourField(0.1, 2.0, 1.0 - below_one).over_own_disc(2.0);
    EXPECT_NEAR(whole / (4.0 * std::numbers::pi), 1.0, below_one);
  }
}

TEST(NeighbourFieldOracle, AgreesWithSumsOverRings) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 40; ++i) {
    const double zone = 1.0 + stream.next_unit(), stem = 0.3 * zone * stream.next_unit() + 0.01;
    const NeighbourField field(stem, zone, 0.05 + 0.5 * stream.next_unit());
    const double radius = 0.1 + 2.0 * stream.next_unit();
    const double distance = (radius + zone) * stream.next_unit();
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(field.over_disc(radius, distance), by_rings(field, radius, distance), 4e-3 * area);
  }
}

TEST(NeighbourFieldOracle, PartsOfADiscAddUp) {
  // A disc is the sum of thin rings around its center: the derivative by the radius is a boundary
  // integral, computed here by the trapezoid rule, which is exact to rounding for smooth periods.
  const NeighbourField field(0.1, 3.0, 0.2);
  const double distance = 1.5, radius = 1.2;
  const double h = 1e-4;
  const double slope =
      (field.over_disc(radius + h, distance) - field.over_disc(radius - h, distance)) / (2 * h);
  double boundary = 0.0;
  constexpr int angles = 20000;
  for (int k = 0; k < angles; ++k) {
    const double phi = 2.0 * std::numbers::pi * k / angles;
    boundary += field.at(std::hypot(distance + radius * std::cos(phi), radius * std::sin(phi)));
  }
  boundary *= 2.0 * std::numbers::pi * radius / angles;
  EXPECT_NEAR(slope / boundary, 1.0, 1e-6);
}

}  // namespace
}  // namespace phytobench
