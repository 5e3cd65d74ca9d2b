// SPDX-License-Identifier: MIT
// How often the printed march and the sweeps are wrong on fractals of any size.
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/wrong_shadows.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

std::vector<int> sizes(Tier tier) {
  switch (tier) {
    case Tier::smoke:
      return {128};
    case Tier::quick:
      return {128, 512};
    case Tier::full:
      break;
  }
  return {128, 512, 1024, 2048};
}

void run(ExperimentContext& context) {
  const int threads = context.untimed_threads();
  for (const int size : sizes(context.tier()))
    record_differences(
        context, fmt::format("fractal-{}", size),
        // As steep in every size.
        fractal_field(size, thesis_cell, size * thesis_cell / 5.0, context.seed() + 9, threads),
        thesis_path(), threads);
}

}  // namespace

extern const ExperimentDescriptor wrong_shadows;
constinit const ExperimentDescriptor wrong_shadows{
    .id = "lesser2019/wrong-shadows",
    .question = "How many pixel-hours do the printed march and the sweeps light wrongly?",
    .source = "[Lesser2019] listing 9.12",
    .seconds = {0.3, 2.0, 120.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
