// SPDX-License-Identifier: MIT
// As line_sweep, but along true lines: a line takes heights between vertices, and a vertex gets
// what reaches it between the two lines beside it. Nothing is interpolated twice, so that shadows
// stay as sharp as they are far away.
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
  // No infinity: what lies between it and a number would be NaN.
  std::vector<double> lines(rows.lines(), std::numeric_limits<double>::lowest() / 4.0);
  for (int swept = 0; swept < rows.count(); ++swept) {
    const double lag = rows.lag(swept), whole = std::floor(lag);
    double* first = lines.data() + rows.first_line() + static_cast<std::ptrdiff_t>(whole);
    std::uint64_t* bits = lit.row(position, rows.place(swept));
    if (lag == whole)
      sweep_lines(rows.row(swept), first, bits);
    else
      sweep_sheared_lines(rows.row(swept), lag - whole, first, bits);
  }
  return {.samples = field.size()};
}

}  // namespace

extern const ShadowEngineDescriptor sheared_sweep;
constinit const ShadowEngineDescriptor sheared_sweep{
    .name = "sheared_sweep",
    .summary = "Carries the greatest height less the rise of a ray along lines between vertices.",
    .source = "after Timonen and Westerholm 2010, for one elevation",
    .exact = false,
    .create = swept_engine<fill>,
};

}  // namespace phytobench::shadow_engines
