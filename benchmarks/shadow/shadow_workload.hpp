// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// A terrain and the suns that shine on it.
struct ShadowWorkload {
  std::string name;
  HeightField field;
  std::vector<SunDirection> suns;

  std::uint64_t vertex_hours() const { return field.size() * suns.size(); }
};

struct FractalShadows {
  int size = 1024;         ///< vertices a side
  double relief = 2000.0;  ///< m
  double cell = 16.0;      ///< m a side; that of the thesis' maps
  int hours = 13;
  std::uint64_t seed = 0;
};

/// Noise of that relief, and hourly_suns().
ShadowWorkload fractal_shadows(const FractalShadows& request);

/// The path of [Lesser2019] sec. 9.2.3 up to the zenith, directions of four decimals as in listing
/// 9.7.
std::vector<SunDirection> hourly_suns(int hours);

/// The corner of the terrain with at most so many vertices a side.
ShadowWorkload corner_of(const ShadowWorkload& workload, int side);

}  // namespace phytobench
