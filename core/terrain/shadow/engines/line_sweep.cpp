// SPDX-License-Identifier: MIT
// Rows from the side of the sun, each vertex on the digital line nearest to its ray: one maximum,
// one subtraction, one comparison. Exact where rays meet vertices (multiples of 45 degrees on
// square cells).
#include <cmath>
#include <limits>
#include <vector>

#include "core/terrain/shadow/line_sweep.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench::shadow_engines {

namespace {

ShadowWork fill(const HeightField& field, const SunDirection& sun, LitMaps& lit,
                std::size_t position) {
  const SweepRows rows(field, sun);
  std::vector<double> lines(rows.lines(), -std::numeric_limits<double>::infinity());
  for (int swept = 0; swept < rows.count(); ++swept) {
    const std::ptrdiff_t first = rows.first_line() + std::lround(rows.lag(swept));
    sweep_lines(rows.row(swept), lines.data() + first, lit.row(position, rows.place(swept)));
  }
  return {.samples = field.size()};
}

}  // namespace

extern const ShadowEngineDescriptor line_sweep;
constinit const ShadowEngineDescriptor line_sweep{
    .name = "line_sweep",
    .summary = "Carries the greatest height less the rise of a ray along digital lines.",
    .source = "after Timonen and Westerholm 2010, for one elevation",
    .exact = false,
    .create = swept_engine<fill>,
};

}  // namespace phytobench::shadow_engines
