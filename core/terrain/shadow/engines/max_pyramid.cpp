// SPDX-License-Identifier: MIT
// Rays over a pyramid of greatest heights, which is the same for every position of the sun.
#include "core/terrain/shadow/pyramid_rays.hpp"
#include "core/terrain/shadow/traced_rows.hpp"

namespace phytobench::shadow_engines {

namespace {

class Engine final : public ShadowEngine {
 public:
  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    const HeightPyramid pyramid(field);
    return cast_each(field, suns, 1, lit, [&](const SunDirection& sun, std::size_t position) {
      return trace(field, pyramid, sun, setup, position, lit);
    });
  }

 private:
  static ShadowWork trace(const HeightField& field, const HeightPyramid& pyramid,
                          const SunDirection& sun, const ShadowSetup& setup, std::size_t position,
                          LitMaps& lit) {
    const PyramidRays rays(field, pyramid, sun, ray_tile_side);
    return trace_rows(field.rows(), setup.threads, [&](int row, ShadowWork& work) {
      // The first row of a tile speaks for all of them; what is left over goes one by one.
      const int in_tile = row % ray_tile_side;
      const bool has_tile = row - in_tile + ray_tile_side <= field.rows();
      const int tiled = has_tile ? field.columns() / ray_tile_side * ray_tile_side : 0;
      if (in_tile == 0)
        for (int column = 0; column < tiled; column += ray_tile_side)
          write(rays.lit_in_tile(column, row, work), column, row, position, lit);
      for (int column = tiled; column < field.columns(); ++column)
        if (!rays.is_blocked(column, row, work)) lit.set_lit(position, column, row);
      work.rays += static_cast<std::uint64_t>(field.columns());
    });
  }

  static void write(std::uint32_t tile, int column, int row, std::size_t position, LitMaps& lit) {
    constexpr std::uint64_t one_row = (1u << ray_tile_side) - 1;
    const auto at = static_cast<std::size_t>(column);
    for (int r = 0; r < ray_tile_side; ++r)
      lit.row(position, row + r)[at / 64] |= ((tile >> (r * ray_tile_side)) & one_row) << (at % 64);
  }
};

std::unique_ptr<ShadowEngine> create() {
  return std::make_unique<Engine>();
}

}  // namespace

extern const ShadowEngineDescriptor max_pyramid;
constinit const ShadowEngineDescriptor max_pyramid{
    .name = "max_pyramid",
    .summary =
        "Follows rays side by side, which pass over whole blocks of lower terrain in one step.",
    .source = "maximum mipmaps, Tevs, Ihrke and Seidel 2008",
    .create = create,
};

}  // namespace phytobench::shadow_engines
