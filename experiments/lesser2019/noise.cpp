// SPDX-License-Identifier: MIT
// Sec. 4.1.1: noise can be made again.
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

std::int64_t different_vertices(const HeightField& a, const HeightField& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a.heights()[i] != b.heights()[i];
  return count;
}

void run(ExperimentContext& context) {
  constexpr int side = 128;
  const auto land = [&](std::uint64_t seed, int threads) {
    return fractal_field(side, thesis_cell, 400.0, seed, threads);
  };
  const HeightField first = land(context.seed(), 1);
  context.record("same-seed-different-vertices", different_vertices(first, land(context.seed(), 1)),
                 "vertices");
  context.record("more-threads-different-vertices",
                 different_vertices(first, land(context.seed(), 4)), "vertices");
  const std::int64_t others = different_vertices(first, land(context.seed() + 1, 1));
  context.record("next-seed-share-of-different-vertices",
                 static_cast<double>(others) / static_cast<double>(first.size()));
}

}  // namespace

extern const ExperimentDescriptor noise;
constinit const ExperimentDescriptor noise{
    .id = "lesser2019/noise",
    .question = "Is noise the same when it is made again?",
    .source = "[Lesser2019] sec. 4.1, 4.1.1",
    .seconds = {0.02, 0.02, 0.02},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
