// SPDX-License-Identifier: MIT
// Stands in for solar_position_nova.cpp where libnova is not installed.
#include "core/contract/errors.hpp"
#include "core/terrain/sun/solar_position.hpp"

namespace phytobench {

namespace {

[[noreturn]] void refuse_to_place_the_sun() {
  throw InputError(
      "where the sun stands on a day needs libnova, which this build does not have; install "
      "libnova-dev and build again, or use the simulated path");
}

}  // namespace

bool can_place_the_sun() {
  return false;
}

SunAngles solar_position(const SolarDay&, double) {
  refuse_to_place_the_sun();
}

std::vector<SunAngles> solar_path(const SolarDay&, int) {
  refuse_to_place_the_sun();
}

double daylight_hours(const SolarDay&) {
  refuse_to_place_the_sun();
}

}  // namespace phytobench
