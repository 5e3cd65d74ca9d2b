// SPDX-License-Identifier: MIT
// Sec. 9.2.2: rays do not depend on each other, and can be shared out. All engines of the suite,
// with one and several threads, against the exact one.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

struct Scene {
  const char* name;
  HeightField field;
};

/// A fractal, the same with cells that are not square, and one with holes and an odd number of
/// columns.
std::vector<Scene> scenes(int size, std::uint64_t seed) {
  const HeightField fractal = fractal_field(size, thesis_cell, size * thesis_cell / 5.0, seed);
  HeightField oblong(size, size, 74.25, 92.5);
  HeightField holes(size - 3, size, thesis_cell, thesis_cell);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      oblong.at(column, row) = 5.0 * fractal.at(column, row);
      if (column < size - 3)
        holes.at(column, row) =
            (column / 7 + row / 5) % 9 == 0 ? HeightField::no_data : fractal.at(column, row);
    }
  return {{"fractal", fractal}, {"oblong-cells", oblong}, {"holes", holes}};
}

void record_engines(ExperimentContext& context) {
  const int size = context.tier() == Tier::smoke ? 65 : 512;
  const std::vector<SunDirection> suns = thesis_path(80.0);
  std::int64_t threads_differ = 0, work_differs = 0, exact_engines = 0, exact_differ = 0, casts = 0;
  for (const Scene& scene : scenes(size, context.seed() + 3)) {
    const Cast exact = cast_by("exact_traversal", scene.field, suns);
    for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
      if (!engine->built()) continue;
      const Cast one = cast_by(engine->name, scene.field, suns);
      for (const int threads : {2, 4, 8}) {
        const Cast several = cast_by(engine->name, scene.field, suns, threads);
        threads_differ += whole(differing_bits(one.lit, several.lit));
        work_differs += one.work != several.work;
        ++casts;
      }
      const std::int64_t differences = whole(differing_bits(one.lit, exact.lit));
      exact_engines += engine->exact;
      if (engine->exact)
        exact_differ += differences;
      else
        context.record(fmt::format("{}/{}/share-of-other-pixel-hours", scene.name, engine->name),
                       static_cast<double>(differences) /
                           static_cast<double>(scene.field.size() * suns.size()));
    }
  }
  context.record("casts", casts);
  context.record("thread-differences", threads_differ, "pixel-hours");
  context.record("thread-differences/work", work_differs, "casts");
  context.record("exact-engines", exact_engines / 3, "engines");
  context.record("exact-engines/other-pixel-hours", exact_differ, "pixel-hours");
}

/// The hours of the path of figure 10.4 in which the sun is above the horizon: at it, any higher
/// vertex hides it, however gentle the land.
std::vector<SunDirection> hours_above_the_horizon() {
  std::vector<SunDirection> suns = thesis_path(80.0);
  std::erase_if(suns, [](const SunDirection& sun) { return sun.up <= 0.0; });
  return suns;
}

bool is_lit_after_dark(const LitMaps& lit, int column, int row) {
  bool was_dark = false, is_relit = false;
  for (std::size_t hour = 0; hour < lit.positions(); ++hour) {
    const bool is_lit = lit.is_lit(hour, column, row);
    is_relit |= was_dark && is_lit;
    was_dark |= !is_lit;
  }
  return is_relit;
}

/// Sec. 8.2.2: what lies in the shadow can be lit in another hour; sec. 10.4: on hilly land most
/// places are in the shadow at some time of the day.
void record_hours_in_shadow(ExperimentContext& context, const char* land, double relief) {
  constexpr int size = 96;
  const HeightField field =
      fractal_field(size, thesis_cell, size * thesis_cell * relief, context.seed() + 3);
  const LitMaps lit = cast_by("exact_traversal", field, hours_above_the_horizon()).lit;
  const std::vector<std::uint16_t> hours = lit_positions(lit);
  std::int64_t relit = 0, shaded = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      shaded += hours[field.index(column, row)] < lit.positions();
      relit += is_lit_after_dark(lit, column, row);
    }
  const double vertices = size * size;
  context.record(fmt::format("{}/dark-at-first-lit-later", land), relit, "vertices");
  context.record(fmt::format("{}/share-shaded-at-some-hour", land),
                 static_cast<double>(shaded) / vertices);
}

void run(ExperimentContext& context) {
  record_engines(context);
  record_hours_in_shadow(context, "hilly", 2.0 / 5.0);
  record_hours_in_shadow(context, "less-hilly", 1.0 / 5.0);
  record_hours_in_shadow(context, "gentle", 1.0 / 50.0);
}

}  // namespace

extern const ExperimentDescriptor shadow_engines;
constinit const ExperimentDescriptor shadow_engines{
    .id = "lesser2019/shadow-engines",
    .question = "Do all engines find the same shadows, with any number of threads?",
    .source = "[Lesser2019] sec. 8.2.2, 9.2.2",
    .seconds = {0.5, 10.0, 10.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
