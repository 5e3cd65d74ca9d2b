// SPDX-License-Identifier: MIT
// Sec. 9.2.2: how the work of the printed march grows with the size of the image.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/terrain/made/resampled.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/oracle_maps.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_march.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

/// One higher pixel in the corner away from the sun, which stands on the horizon: every ray goes to
/// the border.
void record_worst_case(ExperimentContext& context, int size) {
  oracle::Heights map = oracle::flat(size, thesis_cell);
  map.at(0, 0) = 1.0;
  const oracle::PrintedMarch march(map);
  std::int64_t iterations = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      iterations += march.from(column, row, {1.0, 0.0, 0.0}).iterations;
  const std::string name = fmt::format("worst-case/{}/", size);
  context.record(name + "size", std::int64_t{size}, "pixels");
  context.record(name + "iterations", iterations);
  const std::int64_t n = size;
  context.record(name + "off-closed-form", iterations - (n * n * (n + 1) / 2 - n));
}

void record_hours(ExperimentContext& context, const char* land, const HeightField& field,
                  const std::vector<SunDirection>& suns) {
  const std::string name = fmt::format("{}/{}/", land, field.columns());
  context.record(name + "size", std::int64_t{field.columns()}, "pixels");
  const ShadowWork work = cast_by("printed_march", field, suns, context.untimed_threads()).work;
  context.record(name + "rays", whole(work.rays), "rays");
  context.record(name + "samples", whole(work.samples));
}

/// The same ground of 2 km, 200 m high, on pixels of 64, 32 and 16 m: shadows have twice as many
/// pixels with each.
void record_finer(ExperimentContext& context) {
  constexpr int finest = 128;
  const HeightField ground = fractal_field(finest, thesis_cell, 200.0, context.seed());
  for (int size = 32; size <= finest; size *= 2) {
    const int step = finest / size;
    const HeightField field = square_field(size, thesis_cell * step, [&](int column, int row) {
      return ground.at(column * step, row * step);
    });
    record_hours(context, "finer", field, thesis_path());
  }
}

/// The same hills again and again, all with pixels of 16 m: with the sun at least 15 degrees high
/// the length of shadows is the same in all sizes. With it at the horizon, twice in 13 hours, it is
/// not.
void record_hills(ExperimentContext& context, const HeightField& hills, int size) {
  const HeightField field = tiled(hills, size, size);
  const std::vector<SunDirection> suns = thesis_path();
  record_hours(context, "hills", field, {suns.begin() + 1, suns.end() - 1});
  record_hours(context, "hills-in-all-hours", field, suns);
}

void run(ExperimentContext& context) {
  const bool is_smoke = context.tier() == Tier::smoke;
  std::vector<int> sizes = {16, 32, 64};
  if (!is_smoke) sizes.push_back(128);
  for (const int size : sizes) record_worst_case(context, size);
  record_finer(context);
  // 20 m high: shadows of 5 pixels at most while the sun is up, whatever the size.
  const HeightField hills = fractal_field(64, thesis_cell, 20.0, context.seed());
  for (int size = 64; size <= (is_smoke ? 256 : 2048); size *= 2)
    record_hills(context, hills, size);
}

}  // namespace

extern const ExperimentDescriptor march_iterations;
constinit const ExperimentDescriptor march_iterations{
    .id = "lesser2019/march-iterations",
    .question = "How does the work of the printed march grow with the size of the image?",
    .source = "[Lesser2019] sec. 9.2.2",
    .seconds = {0.1, 3.0, 3.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
