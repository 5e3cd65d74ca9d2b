// SPDX-License-Identifier: MIT
// The same on real land: the Jacksboro tile, in smoke runs a part of it.
#include <string>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/real_tile.hpp"
#include "experiments/lesser2019/wrong_shadows.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

void record_tile(ExperimentContext& context, const std::string& name, const HeightField& tile) {
  const int threads = context.untimed_threads();
  context.record(name + "/columns", std::int64_t{tile.columns()}, "vertices");
  context.record(name + "/rows", std::int64_t{tile.rows()}, "vertices");
  context.record(name + "/cell-width", tile.cell_width(), "m");
  context.record(name + "/cell-depth", tile.cell_depth(), "m");
  record_differences(context, name + "-max-90", tile, thesis_path(90.0), threads);
  // A low sun, as in winter, throws long shadows in every hour.
  record_differences(context, name + "-max-20", tile, thesis_path(20.0), threads);
}

void run(ExperimentContext& context) {
  record_tile(context, "squares", real_tile_on_squares(context.tier()));
  // The printed march has one pixel size for both directions, and traps for most sizes.
  record_tile(context, "true-cells", real_tile(context.tier()));
}

}  // namespace

extern const ExperimentDescriptor wrong_shadows_on_tile;
constinit const ExperimentDescriptor wrong_shadows_on_tile{
    .id = "lesser2019/wrong-shadows-on-tile",
    .question =
        "How many pixel-hours of real land do the printed march and the sweeps light "
        "wrongly?",
    .source = "[Lesser2019] listing 9.12",
    .seconds = {0.8, 8.0, 8.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
