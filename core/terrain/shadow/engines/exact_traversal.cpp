// SPDX-License-Identifier: MIT
// Every vertex sends a ray, and the ray looks at every grid line that it crosses: O(n) a ray.
#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/traced_rows.hpp"

namespace phytobench::shadow_engines {

namespace {

bool is_blocked(const RayPattern& pattern, std::size_t crossings, const double* from,
                double highest, ShadowWork& work) {
  for (const RayCrossing& crossing : pattern.crossings().first(crossings)) {
    const double ray = *from + crossing.rise;
    if (!(highest > ray)) return false;
    ++work.samples;
    if (height_at(crossing, from) > ray) return true;
  }
  return false;
}

ShadowWork cast(const HeightField& field, const SunDirection& sun, const ShadowSetup& setup,
                std::size_t position, LitMaps& lit) {
  const RayPattern pattern(field, sun);
  const double highest = height_range(field).highest;
  return trace_rows(field.rows(), setup.threads, [&](int row, ShadowWork& work) {
    for (int column = 0; column < field.columns(); ++column) {
      const double* from = field.row(row) + column;
      if (!is_blocked(pattern, pattern.on_map(column, row), from, highest, work))
        lit.set_lit(position, column, row);
    }
    work.rays += static_cast<std::uint64_t>(field.columns());
  });
}

}  // namespace

extern const ShadowEngineDescriptor exact_traversal;
constinit const ShadowEngineDescriptor exact_traversal{
    .name = "exact_traversal",
    .summary = "Follows a ray from every vertex over every grid line up to the highest height.",
    .source = "grid traversal, Amanatides and Woo 1987",
    .create = shadow_engine_from<cast>,
};

}  // namespace phytobench::shadow_engines
