// SPDX-License-Identifier: MIT
// The problem that sec. 5.3 names: a node between two influence points that makes the same
// successor for ever. Is it the equal distance that does it?
#include <algorithm>
#include <cmath>
#include <map>

#include "core/tree/branches.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int iterations = 500;

std::vector<Vector3> mirrored(double half_distance) {
  return {{half_distance, 0, 0}, {-half_distance, 0, 0}};
}

struct Trap {
  std::int64_t nodes = 0, places = 0, identical = 0;
};
Trap trap_of(const Skeleton& skeleton) {
  std::map<std::pair<double, double>, std::int64_t> places;
  std::map<std::pair<std::int32_t, std::pair<double, double>>, std::int64_t> successors;
  Trap trap;
  for (std::size_t v = 0; v < skeleton.node_count(); ++v) {
    const std::pair<double, double> place{skeleton.positions()[v].x, skeleton.positions()[v].y};
    ++places[place];
    trap.identical = std::max(trap.identical, ++successors[{skeleton.parents()[v], place}]);
  }
  trap.nodes = static_cast<std::int64_t>(skeleton.node_count());
  trap.places = static_cast<std::int64_t>(places.size());
  return trap;
}

/// How much nearer the trapped node, the one with most successors, is to one of the points.
double difference_of_distances(const Seedling& seedling, const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::int32_t trapped = 0;
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(skeleton.node_count()); ++v)
    if (children.of(v).size() > children.of(trapped).size()) trapped = v;
  const Vector3 place = skeleton.position(trapped);
  return std::abs(norm(seedling.attraction_points[0] - place) -
                  norm(seedling.attraction_points[1] - place));
}

GrowthResult measure(ExperimentContext& context, const std::string& scene_name,
                     const Seedling& seedling) {
  const GrowthResult result = grow(seedling);
  const Trap trap = trap_of(result.skeleton);
  const std::string name = scene_name + "/";
  context.record(name + "stop", stop_of(result));
  context.record(name + "nodes", trap.nodes);
  context.record(name + "places", trap.places);
  context.record(name + "identical_successors", trap.identical);
  context.record(name + "points_left", static_cast<std::int64_t>(result.live_points));
  context.record(name + "differs_from_oracle", differs_from_oracle(seedling, result));
  return result;
}

void measure_trap(ExperimentContext& context) {
  const Seedling equal = scene(mirrored(40), {0, -50, 0}, iterations);
  const GrowthResult trapped = measure(context, "equal", equal);
  context.record("equal/difference_of_distances", difference_of_distances(equal, trapped.skeleton),
                 "length");
  measure(context, "equal-for-twice-as-long", scene(mirrored(40), {0, -50, 0}, 2 * iterations));
  measure(context, "equal-without-repeats", without_repeats(equal));
  Seedling limited = equal;
  limited.growth.limits.most_children = 3;
  const GrowthResult three = grow(limited);
  context.record("equal-at-most-3-successors/stop", stop_of(three));
  context.record("equal-at-most-3-successors/nodes", nodes_of(three));
  context.record("equal-at-most-3-successors/iterations", iterations_that_grew(three));
  measure(context, "equal-within-minimal-radius", scene(mirrored(19), {0, -50, 0}, iterations));
}

/// No two distances are the same, and the node is caught all the same.
void measure_unequal(ExperimentContext& context) {
  const Seedling unequal = scene({{60, 5, 0}, {-35, -5, 0}}, {0, -50, 0}, iterations);
  const GrowthResult result = measure(context, "unequal", unequal);
  context.record("unequal/difference_of_distances",
                 difference_of_distances(unequal, result.skeleton), "length");
  // Of how many pairs at random, none equally far from the root, is a node caught?
  CounterStream stream(context.seed(), 3299);
  std::int64_t caught = 0, caught_without_repeats = 0;
  constexpr int pairs = 200;
  for (int i = 0; i < pairs; ++i) {
    const Vector3 a{stream.next_between(25, 60), stream.next_between(-10, 10), 0};
    const Vector3 b{-stream.next_between(25, 60), stream.next_between(-10, 10), 0};
    const Seedling pair = scene({a, b}, {0, -50, 0}, iterations);
    caught += grow(pair).stop_reason == StopReason::iteration_limit;
    caught_without_repeats +=
        grow(without_repeats(pair)).stop_reason == StopReason::iteration_limit;
  }
  Record record;
  record.measurement = "random-pairs/caught";
  record.value = caught;
  record.seed = context.seed();
  record.sample_size = pairs;
  context.record(record);
  record.measurement = "random-pairs/caught_without_repeats";
  record.value = caught_without_repeats;
  context.record(record);
}

/// Exactly between the points eq. 3.2 is 0/0.
void measure_middle(ExperimentContext& context) {
  const Seedling middle = scene(mirrored(40), {0, -45, 0}, iterations);
  const GrowthResult result = grow(middle);
  context.record("middle/nodes", nodes_of(result));
  context.record("middle/height_of_last", result.skeleton.positions().back().y, "length");
  const auto literal = oracles::liebemann2017::colonize(literal_scene(middle));
  context.record("middle/printed_is_undefined",
                 std::int64_t{literal.stop == oracles::liebemann2017::Stop::undefined});
  context.record("middle/printed_nodes", static_cast<std::int64_t>(literal.nodes.size()));
  Seedling pulled = without_repeats(middle);
  pulled.growth.tropism = {0, 0.5, 0};
  context.record("middle-with-tropism/nodes", nodes_of(grow(pulled)));
}

void run(ExperimentContext& context) {
  measure_trap(context);
  measure_unequal(context);
  measure_middle(context);
}

}  // namespace

extern const ExperimentDescriptor two_points;
constinit const ExperimentDescriptor two_points{
    .id = "liebemann2017/two-points",
    .question = "When do two influence points make a node grow the same successor for ever?",
    .source = "[Liebemann2017] sec. 5.3",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
