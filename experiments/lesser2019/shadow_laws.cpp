// SPDX-License-Identifier: MIT
// Laws that shadows obey, whatever the terrain: on fractals, with the exact engine and the printed
// march.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

constexpr int side = 64;
constexpr double relief = 400.0;

/// Heights in 1/1024 m: sums and doubles of them are exact.
HeightField scene(std::uint64_t seed) {
  HeightField field = fractal_field(side, thesis_cell, relief, seed);
  for (double& height : field.heights()) height = std::floor(height * 1024.0) / 1024.0;
  return field;
}

template <class Change>
HeightField changed(HeightField field, const Change& change) {
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 0; column < field.columns(); ++column)
      field.at(column, row) = change(field.at(column, row), column, row);
  return field;
}

/// Vertices that are lit at a lower sun and dark at a higher one, all in one direction.
std::int64_t darker_under_a_higher_sun(const std::string& engine, const HeightField& field) {
  std::int64_t darker = 0;
  for (const double azimuth : {0.0, 15.0, 75.0, 135.0, 200.0, 290.0}) {
    std::vector<SunDirection> suns;
    for (int elevation = 0; elevation <= 80; elevation += 10)
      suns.push_back(rounded(direction_of({static_cast<double>(elevation), azimuth}), 4));
    const LitMaps lit = cast_by(engine, field, suns).lit;
    for (std::size_t i = 1; i < suns.size(); ++i)
      for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
          darker += lit.is_lit(i - 1, column, row) && !lit.is_lit(i, column, row);
  }
  return darker;
}

/// A needle in the corner away from the sun lets the ray go on to its height, and hides nothing
/// from anybody else.
std::int64_t changed_by_high_corner(const std::string& engine, const HeightField& field) {
  std::int64_t differences = 0;
  for (const SunDirection& sun : thesis_path()) {
    if (in_zenith(sun)) continue;
    const int corner = sun.east >= 0.0 ? 0 : side - 1;
    const HeightField high = changed(field, [&](double height, int column, int row) {
      return column == corner && row == 0 ? 10.0 * relief : height;
    });
    const LitMaps before = cast_by(engine, field, {sun}).lit,
                  after = cast_by(engine, high, {sun}).lit;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        differences += (column != corner || row != 0) &&
                       before.is_lit(0, column, row) != after.is_lit(0, column, row);
  }
  return differences;
}

/// Other vertices that are lit only since one has been raised.
std::int64_t lit_by_raising(const std::string& engine, const HeightField& field,
                            std::uint64_t seed) {
  const std::vector<SunDirection> suns = thesis_path();
  const LitMaps before = cast_by(engine, field, suns).lit;
  CounterStream stream(seed, 100);
  std::int64_t newly_lit = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const int c = static_cast<int>(stream.next_unit() * side),
              r = static_cast<int>(stream.next_unit() * side);
    const LitMaps after = cast_by(engine,
                                  changed(field,
                                          [&](double height, int column, int row) {
                                            return column == c && row == r ? height + 50.0 : height;
                                          }),
                                  suns)
                              .lit;
    for (std::size_t i = 0; i < suns.size(); ++i)
      for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
          newly_lit += (column != c || row != r) && after.is_lit(i, column, row) &&
                       !before.is_lit(i, column, row);
  }
  return newly_lit;
}

void record_laws(ExperimentContext& context, const std::string& engine) {
  const HeightField field = scene(context.seed());
  const std::vector<SunDirection> suns = thesis_path();
  const LitMaps lit = cast_by(engine, field, suns).lit;
  const auto record = [&](const char* name, std::int64_t number) {
    context.record(fmt::format("{}/{}", engine, name), number, "vertices");
  };
  record("darker-under-a-higher-sun", darker_under_a_higher_sun(engine, field));
  record("changed-by-a-high-corner", changed_by_high_corner(engine, field));
  record("lit-by-raising-another", lit_by_raising(engine, field, context.seed()));
  const HeightField raised = changed(field, [](double height, int, int) { return height + 256.0; });
  record("changed-by-raising-all", whole(differing_bits(lit, cast_by(engine, raised, suns).lit)));
  HeightField doubled(side, side, 2.0 * thesis_cell, 2.0 * thesis_cell);
  std::transform(field.heights().begin(), field.heights().end(), doubled.heights().begin(),
                 [](double height) { return 2.0 * height; });
  record("changed-by-doubling-all", whole(differing_bits(lit, cast_by(engine, doubled, suns).lit)));
  record("lit", whole(lit.lit()));
  record("dark", std::int64_t{side} * side * thesis_hours - whole(lit.lit()));
}

/// A terrain that is its own mirror image, and a path that is, too.
void record_mirror(ExperimentContext& context, const std::string& engine) {
  const HeightField field = scene(context.seed());
  const HeightField symmetric = changed(field, [&](double height, int column, int row) {
    return std::max(height, field.at(side - 1 - column, row));
  });
  const std::vector<std::uint16_t> hours =
      lit_positions(cast_by(engine, symmetric, thesis_path()).lit);
  std::int64_t differences = 0, most = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const int here = hours[symmetric.index(column, row)],
                there = hours[symmetric.index(side - 1 - column, row)];
      differences += here != there;
      most = std::max<std::int64_t>(most, std::abs(here - there));
    }
  context.record(engine + "/mirror-differences", differences, "vertices");
  context.record(engine + "/mirror-differences/most", most, "h");
}

void run(ExperimentContext& context) {
  for (const std::string engine : {"exact_traversal", "printed_march"}) {
    record_laws(context, engine);
    record_mirror(context, engine);
  }
}

}  // namespace

extern const ExperimentDescriptor shadow_laws;
constinit const ExperimentDescriptor shadow_laws{
    .id = "lesser2019/shadow-laws",
    .question = "Which laws do the shadows obey that follow from how light travels?",
    .source = "[Lesser2019] sec. 8.2.2, 9.2.3",
    .seconds = {1.0, 1.0, 1.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
