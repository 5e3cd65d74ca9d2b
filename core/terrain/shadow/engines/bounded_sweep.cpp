// SPDX-License-Identifier: MIT
// A sweep that knows what it does not know: along digital lines it carries a bound of all that the
// rays beside them may have met, and one of what they have met in any case. Between both a ray is
// followed over the pyramid. The maps are those of exact_traversal.
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/terrain/shadow/line_sweep.hpp"
#include "core/terrain/shadow/pyramid_rays.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench::shadow_engines {

namespace {

constexpr std::size_t surely_lit = 0, maybe_lit = 1;

LitMaps bounds_by_rows(const HeightField& field, const SunDirection& sun) {
  const SweepRows rows(field, sun);
  std::vector<double> greatest(rows.lines(), -std::numeric_limits<double>::infinity());
  std::vector<double> least = greatest;
  LitMaps maps(field.columns(), field.rows(), 2);
  const double margin = rows.rounding();
  for (int swept = 0; swept < rows.count(); ++swept) {
    const std::ptrdiff_t first = rows.first_line() + std::lround(rows.lag(swept));
    sweep_bounds(rows.row(swept), {greatest.data() + first, least.data() + first, margin},
                 maps.row(surely_lit, rows.place(swept)), maps.row(maybe_lit, rows.place(swept)));
  }
  return maps;
}

LitMaps bounds_of(const SweptField& swept, const SunDirection& sun) {
  if (!is_sideways(swept.field(), sun)) return bounds_by_rows(swept.field(), sun);
  const LitMaps exchanged = bounds_by_rows(swept.sideways(), sideways(sun));
  LitMaps maps(exchanged.rows(), exchanged.columns(), 2);
  transpose_bits(exchanged, surely_lit, maps, surely_lit);
  transpose_bits(exchanged, maybe_lit, maps, maybe_lit);
  return maps;
}

/// Follows the rays that the bounds have left open.
ShadowWork decide(const PyramidRays& rays, const LitMaps& bounds, LitMaps& lit,
                  std::size_t position) {
  ShadowWork work;
  for (int row = 0; row < lit.rows(); ++row)
    for (std::size_t word = 0; word < lit.words_per_row(); ++word) {
      std::uint64_t found = bounds.row(surely_lit, row)[word];
      for (std::uint64_t open = bounds.row(maybe_lit, row)[word] & ~found; open != 0;
           open &= open - 1) {
        const int bit = std::countr_zero(open);
        ++work.rays;
        if (!rays.is_blocked(static_cast<int>(word) * 64 + bit, row, work))
          found |= std::uint64_t{1} << bit;
      }
      lit.row(position, row)[word] = found;
    }
  return work;
}

class Engine final : public ShadowEngine {
 public:
  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    const SweptField swept(field, suns);
    const HeightPyramid pyramid(field);
    return cast_each(
        field, suns, setup.threads, lit, [&](const SunDirection& sun, std::size_t position) {
          const LitMaps bounds = bounds_of(swept, sun);
          const PyramidRays rays(field, pyramid, sun, 1);
          return decide(rays, bounds, lit, position) + ShadowWork{.samples = field.size()};
        });
  }
};

std::unique_ptr<ShadowEngine> create() {
  return std::make_unique<Engine>();
}

}  // namespace

extern const ShadowEngineDescriptor bounded_sweep;
constinit const ShadowEngineDescriptor bounded_sweep{
    .name = "bounded_sweep",
    .summary = "Sweeps bounds of what each ray meets, and follows only rays that they leave open.",
    .source = "phytobench",
    .create = create,
};

}  // namespace phytobench::shadow_engines
