// SPDX-License-Identifier: MIT
// What faulty engines begin with, before each makes its mistake.
#pragma once

#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/shadow/traced_rows.hpp"

namespace phytobench::shadow_engines {

/// Lights what blocks(crossing, from) says of no crossing; rays go over `most` of them.
template <class Blocks>
ShadowWork light_rays(const HeightField& field, const SunDirection& sun, std::size_t position,
                      std::size_t most, LitMaps& lit, const Blocks& blocks) {
  const RayPattern pattern(field, sun);
  return trace_rows(field.rows(), 1, [&](int row, ShadowWork& work) {
    for (int column = 0; column < field.columns(); ++column) {
      const std::size_t end = std::min(most, pattern.on_map(column, row));
      const double* from = field.row(row) + column;
      bool is_lit = true;
      for (std::size_t c = 0; c < end && is_lit; ++c, ++work.samples)
        is_lit = !blocks(pattern.crossings()[c], from);
      if (is_lit) lit.set_lit(position, column, row);
    }
  });
}

}  // namespace phytobench::shadow_engines
