// SPDX-License-Identifier: MIT
// Figure 3.2 speaks of a ring with one radius and of no root: which regions and roots let a tree
// grow?
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"
#include "experiments/liebemann2017/random_words.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// A region and a root, repeated for a few clouds.
struct Reading {
  const char* name;
  RoundShape shape;
  double inner_radius;
  Vector3 root;
};

const Vector3 centre{}, lowest{0, -ring_radius, 0};

constexpr std::uint64_t clouds = 2;

void measure(ExperimentContext& context, const Reading& reading) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t least = none, greatest = 0, fewest_tips = none, most_tips = 0, left = 0;
  std::int64_t never_grew = 0, out_of_reach = 0, different = 0;
  for (std::uint64_t i = 0; i < clouds; ++i) {
    const Seedling seedling =
        without_repeats(scene(cloud(round_region(reading.shape, ring_radius, reading.inner_radius),
                                    ring_points, context.seed(), 400 + i),
                              reading.root));
    const GrowthResult result = grow(seedling);
    least = std::min(least, nodes_of(result));
    greatest = std::max(greatest, nodes_of(result));
    const auto tips = static_cast<std::int64_t>(tip_count(result.skeleton));
    fewest_tips = std::min(fewest_tips, tips);
    most_tips = std::max(most_tips, tips);
    left = std::max(left, static_cast<std::int64_t>(result.live_points));
    never_grew += nodes_of(result) == 1;
    out_of_reach += result.stop_reason == StopReason::no_point_in_range;
    if (i == 0 && reading.shape == RoundShape::ring)
      different += differs_from_oracle(seedling, result);
  }
  const std::string name = fmt::format("{}/", reading.name);
  record_seeded(context, name + "nodes/least", least);
  record_seeded(context, name + "nodes/greatest", greatest);
  record_seeded(context, name + "tips/least", fewest_tips);
  record_seeded(context, name + "tips/greatest", most_tips);
  record_seeded(context, name + "points_left/greatest", left);
  record_seeded(context, name + "never_grew", never_grew);
  record_seeded(context, name + "stopped_out_of_reach", out_of_reach);
  if (reading.shape == RoundShape::ring)  // few nodes, and so few distances
    record_seeded(context, name + "differs_from_oracle", different);
}

void run(ExperimentContext& context) {
  const Reading readings[] = {
      {"disc-root-below", RoundShape::disc, 0, lowest},
      {"disc-root-in-the-middle", RoundShape::disc, 0, centre},
      {"annulus-root-below", RoundShape::annulus, 250, lowest},
      {"annulus-root-in-the-middle", RoundShape::annulus, 250, centre},
      {"narrow-hole-root-in-the-middle", RoundShape::annulus, 90, centre},
      {"circle-root-on-it", RoundShape::ring, 0, lowest},
      {"circle-root-in-the-middle", RoundShape::ring, 0, centre},
  };
  record_seeded(context, "clouds", static_cast<std::int64_t>(clouds));
  for (const Reading& reading : readings) {
    context.progress(reading.name);
    measure(context, reading);
  }
}

}  // namespace

extern const ExperimentDescriptor ring_readings;
constinit const ExperimentDescriptor ring_readings{
    .id = "liebemann2017/ring-readings",
    .question = "Which readings of the ring of figure 3.2 let a tree grow?",
    .source = "[Liebemann2017] fig. 3.2",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
