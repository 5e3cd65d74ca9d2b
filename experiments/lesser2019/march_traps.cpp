// SPDX-License-Identifier: MIT
// Listing 9.12: rays that come to no end, and divisions by zero, which no pixel of 16 m shows.
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

constexpr int size = 32;

struct Faults {
  std::int64_t stuck = 0;
  std::int64_t crashed = 0;
};

/// Of rays over flat land that nothing stops, from every pixel in one hour.
Faults faults(double pixel, const oracle::Direction& sun, const oracle::MarchForm& form) {
  const oracle::Heights flat = oracle::flat(size, pixel);
  const oracle::PrintedMarch march(flat, form);
  Faults found;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const oracle::Outcome outcome =
          march.over(column, row, 0.0, {sun.u, sun.v, 0.0}, 1.0).outcome;
      found.stuck += outcome == oracle::Outcome::stuck;
      found.crashed += outcome == oracle::Outcome::crashed;
    }
  return found;
}

void record_day(ExperimentContext& context, const std::string& name, double pixel,
                const oracle::MarchForm& form) {
  Faults day;
  for (const oracle::Direction& sun : oracle::directions({})) {
    const Faults hour = faults(pixel, sun, form);
    day.stuck += hour.stuck;
    day.crashed += hour.crashed;
  }
  context.record(name + "/stuck", day.stuck, "rays");
  context.record(name + "/crashed", day.crashed, "rays");
}

/// The suite's engine on the same pixels gives such rays up and says how many there were.
void record_engine(ExperimentContext& context, double pixel) {
  HeightField field(size, size, pixel, pixel);
  field.at(0, 0) = 1.0;
  const Cast cast = cast_by("printed_march", field, thesis_path(0.0));
  context.record(fmt::format("pixel-{}/given-up-by-the-suite", pixel), whole(cast.work.stuck),
                 "rays");
}

void run(ExperimentContext& context) {
  context.record("rays", std::int64_t{size} * size * thesis_hours, "rays");
  for (const double pixel : {0.1, 7.3, 10.0, 16.0}) {
    record_day(context, fmt::format("pixel-{}", pixel), pixel, {});
    record_day(context, fmt::format("pixel-{}/guarded", pixel), pixel, {.unguarded = false});
    record_engine(context, pixel);
  }
  // A ray that starts in the middle of a pixel.
  const oracle::Direction first_hour = oracle::directions({})[0];
  const Faults centre = faults(16.0, first_hour, {.start = oracle::Start::centre});
  context.record("pixel-16/from-the-centre/hour-1/crashed", centre.crashed, "rays");
}

}  // namespace

extern const ExperimentDescriptor march_traps;
constinit const ExperimentDescriptor march_traps{
    .id = "lesser2019/march-traps",
    .question = "Does the printed march come to an end from every pixel?",
    .source = "[Lesser2019] listing 9.12",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
