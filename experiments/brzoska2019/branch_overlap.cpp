// SPDX-License-Identifier: MIT
// Whether branches of grown trees run into each other. Next to a branching thick branches cannot
// but meet, so pairs of edges count by how many edges lie between them.
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/tree/branch_overlaps.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/pendulous_branches.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Overlaps {
  std::int64_t beside_branchings = 0;
  std::int64_t apart_from_them = 0;
};

/// Whether a branching no longer explains why two branches meet: four edges lie between them, and
/// four times the sum of their radii. Straight branches that still meet there must have left one
/// node at less than 29 degrees.
bool is_apart(const BranchOverlap& overlap, std::span<const double> radii, double step_length) {
  const double sum = radii[static_cast<std::size_t>(overlap.lower_index)] +
                     radii[static_cast<std::size_t>(overlap.higher_index)];
  return overlap.edges_between >= 4 && overlap.edges_between * step_length >= 4.0 * sum;
}

Overlaps overlaps_of(const Skeleton& tree, const TreeParameters& parameters,
                     std::span<const double> radii) {
  Overlaps overlaps;
  for (const BranchOverlap& overlap : branch_overlaps(tree, radii))
    ++(is_apart(overlap, radii, parameters.step_length) ? overlaps.apart_from_them
                                                        : overlaps.beside_branchings);
  return overlaps;
}

std::vector<double> radii_of(const Skeleton& tree, const TreeParameters& parameters) {
  return branch_radii(tree, parameters.plant.tip_radius, parameters.plant.radius_exponent);
}

std::int64_t nodes_at_places_taken(const Skeleton& tree) {
  std::set<std::tuple<double, double, double>> places;
  for (const Vector3& p : tree.positions()) places.insert({p.x, p.y, p.z});
  return static_cast<std::int64_t>(tree.node_count() - places.size());
}

void record_overlaps(ExperimentContext& context, const std::string& name,
                     const Overlaps& overlaps) {
  context.record(name + "/pairs-beside-branchings", overlaps.beside_branchings, "pairs");
  context.record(name + "/pairs-apart", overlaps.apart_from_them, "pairs");
}

/// The thesis' trees, and the same with all their branches bent more than in any of its figures:
/// growth leaves room, bending takes none into account.
void record_thesis_trees(ExperimentContext& context) {
  for (const char* figure :
       {"figure-40-left", "figure-41-left", "figure-42-left", "figure-42-right", "figure-43-left",
        "figure-44-left", "figure-45-left", "figure-46-left", "figure-47-left", "figure-47-right",
        "figure-51"}) {
    context.progress(figure);
    const TreeParameters parameters = thesis_tree(figure);
    const Skeleton tree = grow_seedling(make_seedling(parameters), context).skeleton;
    const std::vector<double> radii = radii_of(tree, parameters);
    const std::string name = std::string("thesis-tree/") + figure;
    context.record(name + "/edges", static_cast<std::int64_t>(tree.edge_count()), "edges");
    context.record(name + "/nodes-at-places-taken", nodes_at_places_taken(tree), "nodes");
    record_overlaps(context, name, overlaps_of(tree, parameters, radii));
    const Skeleton bent = bend_branches(tree, {.intensity = 0.8, .first_order = 12});
    record_overlaps(context, name + "/bent", overlaps_of(bent, parameters, radii));
  }
}

/// Figure 43, whose branches hang as its author published them.
void record_hanging_branches(ExperimentContext& context) {
  for (const char* figure : {"figure-43-left", "figure-43-middle"}) {
    const TreeParameters parameters = thesis_tree(figure);
    const Skeleton tree = grow_seedling(make_seedling(parameters), context).skeleton;
    const Skeleton bent = bend_branches(tree, parameters.plant.pendulous);
    record_overlaps(context, std::string("hanging/") + figure,
                    overlaps_of(bent, parameters, radii_of(tree, parameters)));
  }
}

/// Figure 47's gnarled tree with other seeds, unbent: how often branches meet.
void record_seeds(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-47-right");
  std::int64_t trees_with_overlaps = 0;
  record_trees(context, "gnarled/pairs-apart", "pairs", [&](std::size_t number) {
    const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
    const Skeleton tree = grow_seedling(seedling, context).skeleton;
    const std::int64_t pairs =
        overlaps_of(tree, parameters, radii_of(tree, parameters)).apart_from_them;
    trees_with_overlaps += pairs > 0;
    return static_cast<double>(pairs);
  });
  context.record({.experiment = {},
                  .measurement = "gnarled/trees-with-pairs-apart",
                  .value = trees_with_overlaps,
                  .unit = "trees",
                  .sample_size = static_cast<std::int64_t>(trees_per_trend),
                  .seed = context.seed()});
}

void run(ExperimentContext& context) {
  record_thesis_trees(context);
  record_hanging_branches(context);
  record_seeds(context);
}

}  // namespace

extern const ExperimentDescriptor branch_overlap;
constinit const ExperimentDescriptor branch_overlap{
    .id = "brzoska2019/branch-overlap",
    .question = "Do branches of grown trees run into each other?",
    .source = "[Brzoska2019] sec. 4.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
