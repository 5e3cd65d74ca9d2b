// SPDX-License-Identifier: MIT
// The thesis does not say what the terrain is between two pixels: three readings, on planes, whose
// shadows are known, and on fractals, against the printed march.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/oracle_maps.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_rays.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

struct NamedReading {
  const char* name;
  oracle::Reading reading;
};
constexpr std::array readings = {NamedReading{"surface", oracle::Reading::surface},
                                 NamedReading{"foot", oracle::Reading::foot},
                                 NamedReading{"entry", oracle::Reading::entry}};

double tangent(double degrees) {
  return std::tan(degrees * (std::numbers::pi / 180.0));
}

/// Planes that rise towards the east, the sun 30 degrees high: dark only where the plane is steeper
/// than that in the sun's direction.
void record_ramps(ExperimentContext& context) {
  constexpr double elevation = 30.0;
  std::array<std::int64_t, readings.size()> wrong{};
  std::int64_t ramps = 0, wrongly_marched = 0;
  for (const double slope : {10.0, 16.0, 20.0, 29.0, 31.0, 40.0})
    for (const double azimuth : {0.0, 15.0, 30.0, 45.0}) {
      const HeightField field = square_field(
          32, thesis_cell, [&](int column, int) { return tangent(slope) * thesis_cell * column; });
      const oracle::Heights map = oracle_map(field);
      const SunDirection sun = direction_of({elevation, azimuth});
      const double towards_sun = tangent(slope) * std::cos(azimuth * (std::numbers::pi / 180.0));
      const bool is_lit = towards_sun <= tangent(elevation);
      for (std::size_t i = 0; i < readings.size(); ++i)
        wrong[i] += oracle::ray(map, 8, 8, oracle_sun(sun), readings[i].reading).lit != is_lit;
      wrongly_marched +=
          cast_by("printed_march", field, {rounded(sun, 4)}).lit.is_lit(0, 8, 8) != is_lit;
      ++ramps;
    }
  context.record("ramps", ramps, "ramps");
  for (std::size_t i = 0; i < readings.size(); ++i)
    context.record(fmt::format("ramps/wrong/{}", readings[i].name), wrong[i], "ramps");
  context.record("ramps/wrong/printed", wrongly_marched, "ramps");
}

/// Counts over all pixels and hours.
struct Fractal {
  std::int64_t pixel_hours = 0;
  std::int64_t lit_by_march = 0;
  std::array<std::int64_t, readings.size()> lit{};
  std::array<std::int64_t, readings.size()> differs_from_march{};
  std::array<std::int64_t, readings.size()> differs_from_surface{};
};

Fractal compare(const HeightField& field) {
  const oracle::Heights map = oracle_map(field);
  const std::vector<SunDirection> suns = thesis_path();
  const LitMaps marched = cast_by("printed_march", field, suns).lit;
  Fractal counts;
  for (std::size_t hour = 0; hour < suns.size(); ++hour)
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < field.columns(); ++column) {
        const bool is_marched = marched.is_lit(hour, column, row);
        ++counts.pixel_hours;
        counts.lit_by_march += is_marched;
        std::array<bool, readings.size()> lit{};
        for (std::size_t i = 0; i < readings.size(); ++i) {
          lit[i] = in_zenith(suns[hour]) ||
                   oracle::ray(map, column, row, oracle_sun(suns[hour]), readings[i].reading).lit;
          counts.lit[i] += lit[i];
          counts.differs_from_march[i] += lit[i] != is_marched;
          counts.differs_from_surface[i] += lit[i] != lit[0];
        }
      }
  return counts;
}

void record_fractal(ExperimentContext& context, const std::string& name, int size,
                    std::uint64_t seed) {
  const Fractal counts = compare(fractal_field(size, thesis_cell, 400.0, seed));
  const auto share = [&](std::int64_t number) {
    return static_cast<double>(number) / static_cast<double>(counts.pixel_hours);
  };
  context.record(name + "/pixel-hours", counts.pixel_hours);
  context.record(name + "/printed/lit", counts.lit_by_march);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::string reading = fmt::format("{}/{}/", name, readings[i].name);
    context.record(reading + "lit", counts.lit[i]);
    context.record(reading + "printed-is-other", share(counts.differs_from_march[i]));
    context.record(reading + "is-not-the-surface", share(counts.differs_from_surface[i]));
  }
}

void run(ExperimentContext& context) {
  record_ramps(context);
  record_fractal(context, "fractal-64-first", 64, context.seed() + 1);
  record_fractal(context, "fractal-64-second", 64, context.seed() + 2);
  if (context.tier() != Tier::smoke)
    record_fractal(context, "fractal-128", 128, context.seed() + 1);
}

}  // namespace

extern const ExperimentDescriptor shadow_readings;
constinit const ExperimentDescriptor shadow_readings{
    .id = "lesser2019/shadow-readings",
    .question = "How much does a shadow depend on what the terrain is between two pixels?",
    .source = "[Lesser2019] sec. 8.2.2, 8.3",
    .seconds = {0.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
