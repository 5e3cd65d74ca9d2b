// SPDX-License-Identifier: MIT
// Eq. 3.2 adds the tropism vector to the sum of eq. 3.3, not to its unit vector.
#include <cmath>

#include "core/colonization/growth_direction.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"
#include "experiments/liebemann2017/random_words.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// A root with k influence points to the right and a tropism of length 1.
Seedling aligned_points(int k, const Vector3& tropism, TropismOrder order) {
  std::vector<Vector3> points;
  for (int i = 0; i < k; ++i) points.push_back({40.0 + 5.0 * i, 0, 0});
  Seedling seedling = scene(points, {}, 1);
  seedling.growth.tropism = tropism;
  seedling.growth.variant.tropism_order = order;
  return seedling;
}

double first_angle_deg(const GrowthResult& result) {
  const Vector3 place = result.skeleton.position(1);
  return std::atan2(place.y, place.x) * 180.0 / std::numbers::pi;
}

void measure_aligned_points(ExperimentContext& context) {
  std::int64_t different = 0;
  double step_off = 0.0;
  for (const int k : {1, 2, 4, 8}) {
    for (const auto& [order, name] : {std::pair{TropismOrder::before_normalising, "printed"},
                                      std::pair{TropismOrder::after_normalising, "unit_vector"}}) {
      const Seedling seedling = aligned_points(k, {0, 1, 0}, order);
      const GrowthResult result = grow(seedling);
      context.record(fmt::format("aligned/k-{}/{}", k, name), first_angle_deg(result), "deg");
      different += differs_from_oracle(seedling, result);
      step_off = std::max(step_off, std::abs(norm(result.skeleton.position(1)) - step_length));
    }
  }
  context.record("aligned/differs_from_oracle", different);
  context.record("aligned/step_off", step_off, "length");
}

/// Where one of the forms has no value, or the tropism wins.
void measure_extremes(ExperimentContext& context) {
  using enum TropismOrder;
  const auto nodes = [](const Seedling& seedling) { return nodes_of(grow(seedling)); };
  context.record("opposite/printed/nodes",
                 nodes(aligned_points(1, {-1, 0, 0}, before_normalising)));
  const auto literal = oracles::liebemann2017::colonize(
      literal_scene(aligned_points(1, {-1, 0, 0}, before_normalising)));
  context.record("opposite/printed_is_undefined",
                 std::int64_t{literal.stop == oracles::liebemann2017::Stop::undefined});
  context.record("opposite/stronger/angle",
                 first_angle_deg(grow(aligned_points(1, {-2, 0, 0}, before_normalising))), "deg");
  context.record("opposite/two_points/angle",
                 first_angle_deg(grow(aligned_points(2, {-1, 0, 0}, before_normalising))), "deg");
  for (const auto& [order, name] :
       {std::pair{before_normalising, "printed"}, std::pair{after_normalising, "unit_vector"}}) {
    Seedling between = scene({{40, 0, 0}, {-40, 0, 0}}, {}, 1);
    between.growth.tropism = {0, 1, 0};
    between.growth.variant.tropism_order = order;
    const GrowthResult result = grow(between);
    context.record(fmt::format("between/{}/nodes", name), nodes_of(result));
    if (nodes_of(result) > 1)
      context.record(fmt::format("between/{}/angle", name), first_angle_deg(result), "deg");
  }
  context.record("strong/angle",
                 first_angle_deg(grow(aligned_points(1, {0, 1e9, 0}, before_normalising))), "deg");
}

/// Whole trees: without tropism the forms agree, with one they do not, and the tree leans.
void measure_trees(ExperimentContext& context) {
  std::int64_t other_without = 0, same_with = 0, different = 0, not_leaning = 0;
  constexpr std::uint64_t clouds = 3;
  for (std::uint64_t i = 0; i < clouds; ++i) {
    Seedling seedling = without_repeats(
        scene(cloud(round_region(RoundShape::disc, 200), 300, context.seed(), 300 + i),
              {0, -200, 0}, 50));
    std::vector<Skeleton> trees;  // without and with tropism, each in both forms
    double mean_x[2] = {};
    for (const int with : {0, 1}) {
      seedling.growth.tropism = {static_cast<double>(with), 0, 0};
      for (const int after : {0, 1}) {
        seedling.growth.variant.tropism_order =
            after ? TropismOrder::after_normalising : TropismOrder::before_normalising;
        const GrowthResult result = grow(seedling);
        trees.push_back(result.skeleton);
        different += differs_from_oracle(seedling, result);
        if (after) continue;
        for (std::size_t v = 1; v < result.skeleton.node_count(); ++v)
          mean_x[with] += (result.skeleton.positions()[v].x -
                           result.skeleton.position(result.skeleton.parents()[v]).x) /
                          static_cast<double>(result.skeleton.edge_count());
      }
    }
    other_without += !same_tree(trees[0], trees[1]);
    same_with += same_tree(trees[2], trees[3]);
    not_leaning += !(mean_x[1] > mean_x[0]);
  }
  record_seeded(context, "trees/other_without_tropism", other_without);
  record_seeded(context, "trees/same_with_tropism", same_with);
  record_seeded(context, "trees/not_leaning", not_leaning);
  record_seeded(context, "trees/differs_from_oracle", different);
}

void run(ExperimentContext& context) {
  measure_aligned_points(context);
  measure_extremes(context);
  measure_trees(context);
}

}  // namespace

extern const ExperimentDescriptor tropism;
constinit const ExperimentDescriptor tropism{
    .id = "liebemann2017/tropism",
    .question = "What does it matter whether tropism joins the sum or its unit vector?",
    .source = "[Liebemann2017] sec. 3.2, eq. 3.2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
