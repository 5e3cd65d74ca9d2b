// SPDX-License-Identifier: MIT
// Listing 9.12: which cells the printed march looks at, and where it ends.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/oracle_maps.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

/// Where rays go that nothing stops.
oracle::MarchResult free_march(const oracle::PrintedMarch& march, int column, int row,
                               const oracle::Direction& sun) {
  return march.over(column, row, 0.0, {sun.u, sun.v, 0.0}, 1.0);
}

/// Of rays from a few pixels, hour by hour.
void record_skipped_cells(ExperimentContext& context) {
  constexpr std::pair<int, int> starts[] = {{2, 3}, {10, 5}, {30, 20}, {33, 2}, {60, 7}, {50, 40}};
  const oracle::Heights flat = oracle::flat(64, thesis_cell);
  double greatest = 0.0;
  int all = 0, all_untested = 0;
  int hour = 0;
  for (const oracle::Direction& sun : oracle::directions({})) {
    ++hour;
    int crossed = 0, untested = 0;
    if (sun.u == 0.0 && sun.v == 0.0) continue;
    for (const auto& [column, row] : starts) {
      const auto printed = oracle::untested_cells(flat, column, row, sun);
      crossed += printed.crossed;
      untested += printed.untested;
    }
    const double share = static_cast<double>(untested) / crossed;
    context.record(fmt::format("skipped-share/hour-{}", hour), share);
    // Along 135 degrees a ray from a corner crosses pixels, and its samples lie on other ones.
    if (hour == 10) continue;
    greatest = std::max(greatest, share);
    all += crossed;
    all_untested += untested;
  }
  context.record("skipped-share/greatest", greatest);
  context.record("skipped-share", static_cast<double>(all_untested) / all);
  context.record("crossed", std::int64_t{all}, "cells");
}

/// A needle that no ray can pass over, on each pixel in turn that a ray from the corner of another
/// crosses. In the morning such a ray meets the mesh beside the needle, too.
void record_needles(ExperimentContext& context) {
  constexpr int size = 32;
  constexpr double needle = 1e9;
  const oracle::Heights flat = oracle::flat(size, thesis_cell);
  const std::vector<SunDirection> suns = thesis_path();
  std::int64_t needles = 0, missed_by_march = 0, missed_by_exact = 0;
  for (std::size_t hour = 1; hour <= 5; ++hour)
    for (const auto& [column, row] : {std::pair(2, 3), std::pair(10, 5)})
      for (const auto& cell :
           oracle::crossed_from_corner(flat, column, row, oracle_sun(suns[hour]))) {
        HeightField field(size, size, thesis_cell, thesis_cell);
        field.at(cell.i, cell.j) = needle;
        const auto is_missed = [&](const char* engine) {
          return cast_by(engine, field, {suns[hour]}).lit.is_lit(0, column, row);
        };
        ++needles;
        missed_by_march += is_missed("printed_march");
        missed_by_exact += is_missed("exact_traversal");
      }
  context.record("needles", needles, "needles");
  context.record("needles/missed/printed_march", missed_by_march, "needles");
  context.record("needles/missed/exact_traversal", missed_by_exact, "needles");
}

/// A tower between a pixel and the sun.
void record_tower(ExperimentContext& context) {
  const HeightField field = square_field(
      16, thesis_cell, [](int column, int row) { return column == 6 && row == 4 ? 1000.0 : 0.0; });
  for (const char* engine : {"printed_march", "exact_traversal"})
    context.record(fmt::format("tower/{}/lit", engine),
                   std::int64_t{cast_by(engine, field, {thesis_path()[1]}).lit.is_lit(0, 4, 4)});
  const oracle::Heights map = oracle_map(field);
  std::string path;
  for (const oracle::Visited& cell :
       oracle::PrintedMarch(map).from(4, 4, oracle::directions({})[1]).visited)
    path += fmt::format("({},{})", cell.i, cell.j);
  context.record("tower/tested", path);
}

/// Cells tested after the ray has left the map: less than a pixel beyond the west and north border
/// a number is cut off to 0.
void record_foreign_edges(ExperimentContext& context) {
  constexpr int size = 32;
  const oracle::Heights flat = oracle::flat(size, thesis_cell);
  for (const bool truncates : {true, false}) {
    std::int64_t tested = 0, foreign = 0;
    const oracle::PrintedMarch march(flat, {.truncates = truncates});
    const std::vector<oracle::Direction> suns = oracle::directions({});
    for (std::size_t hour = 7; hour < suns.size(); ++hour)
      for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
          for (const auto& cell : free_march(march, column, row, suns[hour]).visited) {
            ++tested;
            foreign += cell.X < 0.0 || cell.Y < 0.0;
          }
    const std::string name = truncates ? "" : "/rounded-down";
    context.record("tested-in-the-afternoon" + name, tested, "cells");
    context.record("foreign-edge-tests" + name, foreign, "cells");
  }
}

void record_zenith_and_flat(ExperimentContext& context) {
  constexpr int size = 64;
  const HeightField rough = fractal_field(size, thesis_cell, 400.0, context.seed());
  const HeightField flat(size, size, thesis_cell, thesis_cell, 100.0);
  // A needle darkens something however high the sun, if it is not in the zenith.
  const HeightField needle = square_field(size, thesis_cell, [](int column, int row) {
    return column == 32 && row == 32 ? 1000.0 : 0.0;
  });
  context.record("vertices", std::int64_t{size} * size, "vertices");
  for (const char* engine : {"exact_traversal", "printed_march"}) {
    const std::string name = std::string(engine) + "/";
    context.record(name + "lit-zenith", whole(cast_by(engine, rough, thesis_path()).lit.lit(6)),
                   "vertices");
    std::vector<SunDirection> high;
    for (const double elevation : {85.0, 87.0, 89.0})
      high.push_back(rounded(direction_of({elevation, 0.0}), 4));
    context.record(name + "dark-under-a-high-sun",
                   3 * size * size - whole(cast_by(engine, needle, high).lit.lit()), "vertices");
    const LitMaps lit = cast_by(engine, flat, thesis_path()).lit;
    context.record(name + "flat-lit", whole(lit.lit()), "vertices");
    const auto hours = lit_positions(lit);
    const auto [least, most] = std::minmax_element(hours.begin(), hours.end());
    context.record(name + "flat-raw/least", *least * hourly_solar_energy.value(), "kcal/m2");
    context.record(name + "flat-raw/most", *most * hourly_solar_energy.value(), "kcal/m2");
  }
}

void run(ExperimentContext& context) {
  record_skipped_cells(context);
  record_needles(context);
  record_tower(context);
  record_foreign_edges(context);
  record_zenith_and_flat(context);
}

}  // namespace

extern const ExperimentDescriptor shadow_march;
constinit const ExperimentDescriptor shadow_march{
    .id = "lesser2019/shadow-march",
    .question = "Does the printed march look at every cell that a ray crosses, and at no other?",
    .source = "[Lesser2019] sec. 8.2.2, 9.2.3, listing 9.12",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
