// SPDX-License-Identifier: MIT
#include "benchmarks/shadow/shadow_workload.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/terrain/made/fractal_terrain.hpp"
#include "core/terrain/sun/hourly_path.hpp"

namespace phytobench {

std::vector<SunDirection> hourly_suns(int hours) {
  constexpr int printed_decimals = 4;
  std::vector<SunDirection> suns;
  for (const SunAngles& angles : sun_angles({.hours = hours}))
    suns.push_back(rounded(direction_of(angles), printed_decimals));
  return suns;
}

ShadowWorkload fractal_shadows(const FractalShadows& request) {
  const MapGrid grid{request.size, request.size, request.cell, request.cell};
  return {fmt::format("fractal of {} x {} vertices every {} m, {} m high", request.size,
                      request.size, request.cell, request.relief),
          noise_terrain(grid, {.seed = request.seed, .relief_m = request.relief}),
          hourly_suns(request.hours)};
}

ShadowWorkload corner_of(const ShadowWorkload& workload, int side) {
  const HeightField& field = workload.field;
  HeightField corner(std::min(side, field.columns()), std::min(side, field.rows()),
                     field.cell_width(), field.cell_depth());
  for (int row = 0; row < corner.rows(); ++row)
    std::copy_n(field.row(row), corner.columns(), &corner.at(0, row));
  return {workload.name, std::move(corner), workload.suns};
}

}  // namespace phytobench
