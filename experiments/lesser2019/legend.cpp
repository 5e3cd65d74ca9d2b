// SPDX-License-Identifier: MIT
// Sec. 10.3: the colours of a normal map, coded as is usual: (n + 1) / 2 is red, green and blue.
#include <string>

#include <fmt/format.h>

#include "core/geometry/vector3.hpp"
#include "core/terrain/relief.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

struct Coded {
  double red, green, blue;
};

Coded coded(const Vector3& normal) {
  return {(normal.x + 1.0) / 2.0, (normal.y + 1.0) / 2.0, (normal.z + 1.0) / 2.0};
}

void run(ExperimentContext& context) {
  const Coded level = coded(surface_normal({0.0, 0.0}));
  context.record("up/red", level.red);
  context.record("up/green", level.green);
  context.record("up/blue", level.blue);
  // Slopes of 45 degrees; what falls to the south looks south.
  struct Facing {
    const char* name;
    SurfaceGradient gradient;
  };
  for (const Facing& facing :
       {Facing{"south", {0.0, -1.0}}, Facing{"north", {0.0, 1.0}}, Facing{"east", {-1.0, 0.0}}}) {
    const Coded colour = coded(surface_normal(facing.gradient));
    context.record(fmt::format("{}/red-more-than-up", facing.name), colour.red - level.red);
    context.record(fmt::format("{}/green-more-than-up", facing.name), colour.green - level.green);
    context.record(fmt::format("{}/blue", facing.name), colour.blue);
  }
}

}  // namespace

extern const ExperimentDescriptor legend;
constinit const ExperimentDescriptor legend{
    .id = "lesser2019/legend",
    .question = "Which colours has a normal map where the ground looks south, north and up?",
    .source = "[Lesser2019] sec. 10.3",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
