// SPDX-License-Identifier: MIT
// The same on real land: the Jacksboro tile, in smoke runs a part of it.
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/real_tile.hpp"
#include "experiments/lesser2019/wrong_shadows.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

void run(ExperimentContext& context) {
  const int threads = context.untimed_threads();
  const HeightField tile = real_tile(context.tier());
  context.record("columns", std::int64_t{tile.columns()}, "vertices");
  context.record("rows", std::int64_t{tile.rows()}, "vertices");
  context.record("cell-width", tile.cell_width(), "m");
  context.record("cell-depth", tile.cell_depth(), "m");
  record_differences(context, "max-90", tile, thesis_path(90.0), threads);
  // A low sun, as in winter, throws long shadows in every hour.
  record_differences(context, "max-20", tile, thesis_path(20.0), threads);
}

}  // namespace

extern const ExperimentDescriptor wrong_shadows_on_tile;
constinit const ExperimentDescriptor wrong_shadows_on_tile{
    .id = "lesser2019/wrong-shadows-on-tile",
    .question =
        "How many pixel-hours of real land do the printed march and the sweeps light "
        "wrongly?",
    .source = "[Lesser2019] listing 9.12",
    .seconds = {0.5, 2.0, 2.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
