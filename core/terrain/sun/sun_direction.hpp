// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// The unit vector towards the sun, in the frame of a HeightField.
struct SunDirection {
  double east = 0.0;
  double south = 0.0;
  double up = 1.0;

  friend bool operator==(const SunDirection&, const SunDirection&) = default;
};

/// Where the sun stands, in degrees: above the horizon, and from east over south ([Lesser2019]
/// sec. 8.2.2; most others count from north over east).
struct SunAngles {
  double elevation = 0.0;
  double azimuth = 0.0;
};

/// [Lesser2019] eq. 8.1. Exactly 0 where a sine or cosine of whole quarter turns is.
SunDirection direction_of(const SunAngles& angles);

/// The same rounded to so many decimals, as [Lesser2019] listing 9.7 does with four: no longer
/// quite a unit vector, but 0 where it should be.
SunDirection rounded(const SunDirection& direction, int decimals);

/// Whether no terrain casts a shadow: a height field has no overhangs.
inline bool in_zenith(const SunDirection& sun) {
  return sun.east == 0.0 && sun.south == 0.0 && sun.up > 0.0;
}

}  // namespace phytobench
