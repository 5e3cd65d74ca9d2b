// SPDX-License-Identifier: MIT
// Option D removes points at the start of the next iteration. Five conditions under which that
// grows the same tree as removing at once, each broken on its own; and whether new nodes alone may
// remove points. Runs the literal oracle: core has named options only for the two
// mistakes whose edge counts the sensitivity table lists.
#include <cmath>

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

using namespace oracles::brzoska2019;

/// A small crown with the thesis' start settings.
GrowthProblem small_crown() {
  TreeParameters parameters;
  parameters.cloud.radii = {2.0, 2.8, 1.8};
  parameters.iterations = 20;
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.8);
  parameters.influence_distance = coupling.influence_distance;
  parameters.kill_distance.begin = coupling.kill_distance(0.0);
  parameters.kill_distance.end = coupling.kill_distance(0.8);
  return oracle_problem(make_seedling(parameters));
}

GrowthProblem few_points(std::vector<Point> points, double kill_distance, int iterations) {
  GrowthProblem problem;
  problem.attraction_points = std::move(points);
  problem.start_nodes = {{0, 0, 0}};
  problem.start_directions = {{0, 1, 0}};
  problem.start_parents = {-1};
  problem.iterations = iterations;
  problem.D = 0.25;
  problem.d_i = 0.55;
  problem.theta_rad = 160.0 * std::numbers::pi / 180.0;
  problem.d_c = [kill_distance](int) { return kill_distance; };
  return problem;
}

/// The first child stands exactly one kill distance below the first point: <= removes it, < does
/// not, and then it still pulls when the second point comes into reach.
GrowthProblem point_at_kill_distance() {
  return few_points({{0, 0.5, 0}, {0.3, 0.7, 0}}, 0.25, 3);
}

/// One step removes the only point.
GrowthProblem single_point() {
  return few_points({{0, 0.4, 0}}, 0.3, 5);
}

bool same_tree(const GrownTree& a, const GrownTree& b) {
  if (a.parents != b.parents) return false;
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
    if (length(minus(a.nodes[i], b.nodes[i])) != 0) return false;
  return true;
}

GrownTree grow_deferred(GrowthProblem problem, DeferredRemoval deferred) {
  deferred.enabled = true;
  problem.deferred = deferred;
  return grow(problem);
}

std::int64_t yes(bool statement) {
  return statement ? 1 : 0;
}

void record_all_nodes(ExperimentContext& context) {
  for (const bool shrinking : {true, false}) {
    GrowthProblem problem = small_crown();
    if (!shrinking)
      problem.d_c = [forward = problem.d_c, n = problem.iterations](int i) {
        return forward(n - 1 - i);
      };
    const GrownTree new_only = grow(problem);
    problem.departures.all_nodes_kill = true;
    context.record(std::string("all_nodes_kill/same_tree_") + (shrinking ? "shrinking" : "growing"),
                   yes(same_tree(new_only, grow(problem))));
  }
}

void run(ExperimentContext& context) {
  const GrowthProblem crown = small_crown();
  const GrownTree immediate = grow(crown);
  const GrownTree kept = grow_deferred(crown, {});
  context.record("immediate/edges", static_cast<std::int64_t>(immediate.nodes.size() - 1));
  context.record("kept/edges", static_cast<std::int64_t>(kept.nodes.size() - 1));
  context.record("kept/same_tree", yes(same_tree(immediate, kept)));

  context.progress("breaking the conditions one by one");
  context.record(
      "condition-1/same_tree",
      yes(same_tree(immediate, grow_deferred(crown, {.first_pass_removes_nothing = false}))));
  context.record(
      "condition-2/same_tree",
      yes(same_tree(immediate, grow_deferred(crown, {.uses_previous_kill_distance = false}))));
  const GrowthProblem tie = point_at_kill_distance();
  context.record("condition-3/kept_same_tree", yes(same_tree(grow(tie), grow_deferred(tie, {}))));
  context.record(
      "condition-3/same_tree",
      yes(same_tree(grow(tie), grow_deferred(tie, {.compares_like_immediate_removal = false}))));
  context.record(
      "condition-4/same_tree",
      yes(same_tree(immediate, grow_deferred(crown, {.ignores_perception_angle = false}))));
  const GrowthProblem last = single_point();
  const GrownTree early_test = grow_deferred(last, {.stop_test_follows_removal = false});
  context.record("condition-5/same_tree", yes(same_tree(grow(last), early_test)));
  context.record("condition-5/extra_iterations",
                 static_cast<std::int64_t>(early_test.passes.size() - grow(last).passes.size()));
  record_all_nodes(context);
}

}  // namespace

extern const ExperimentDescriptor deferred_removal;
constinit const ExperimentDescriptor deferred_removal{
    .id = "brzoska2019/deferred-removal",
    .question =
        "Under which conditions does removing points one iteration later grow the same tree?",
    .source = "[Brzoska2019] sec. 5.2.2, option D",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
