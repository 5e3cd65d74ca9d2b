// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/shadow_checks.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/terrain/sun/sun_direction.hpp"
#include "reference/oracles/lesser2019_rays.hpp"

namespace phytobench {

namespace {

namespace lesser = oracles::lesser2019;

lesser::Heights heights_of(const HeightField& field) {
  return {field.columns(),
          field.rows(),
          field.cell_width(),
          field.cell_depth(),
          {field.heights().begin(), field.heights().end()}};
}

std::uint64_t wrong_rays(const lesser::Heights& heights, const SunDirection& sun,
                         const LitMaps& lit, std::size_t position) {
  constexpr double rounding_m = 1e-9;
  std::uint64_t wrong = 0;
  for (int row = 0; row < heights.n_y; ++row)
    for (int column = 0; column < heights.n_x; ++column) {
      bool is_lit = sun.up >= 0.0;
      if (is_lit && !in_zenith(sun)) {
        const lesser::Ray ray = lesser::ray(heights, column, row, {sun.east, sun.south, sun.up},
                                            lesser::Reading::surface);
        if (std::abs(ray.margin) < rounding_m) continue;
        is_lit = ray.lit;
      }
      wrong += is_lit != lit.is_lit(position, column, row);
    }
  return wrong;
}

}  // namespace

std::string objection_to_shadows(const ShadowWorkload& workload, const LitMaps& lit,
                                 double wrong_share) {
  if (lit.columns() != workload.field.columns() || lit.rows() != workload.field.rows() ||
      lit.positions() != workload.suns.size())
    return "there are no maps of this terrain and these suns";
  const lesser::Heights heights = heights_of(workload.field);
  std::uint64_t wrong = 0;
  for (std::size_t s = 0; s < workload.suns.size(); ++s)
    wrong += wrong_rays(heights, workload.suns[s], lit, s);
  const double share = static_cast<double>(wrong) / static_cast<double>(workload.vertex_hours());
  if (share <= wrong_share) return {};
  return fmt::format("{} of {} rays end otherwise than they must", wrong, workload.vertex_hours());
}

}  // namespace phytobench
