// SPDX-License-Identifier: MIT
// Where in a crown branches branch: inside or outside. Counted with attraction points near the
// envelope alone, with kill distances that shrink or stay, and in the thesis' own trees.
#include <cmath>

#include <fmt/format.h>

#include "core/tree/branches.hpp"
#include "core/tree/habit.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// Places in a cloud by the ellipsoid's radius there: 0 at its centre, 1 at its surface.
class EllipsoidRadius {
 public:
  EllipsoidRadius(const CutEllipsoid& shape, const Vector3& crown_root)
      : radii_(shape.radii),
        centre_(crown_root + Vector3{0, shape.radii.y * (1.0 - 2.0 * shape.cutoff_bottom), 0}) {}

  double operator()(const Vector3& place) const {
    const Vector3 offset = place - centre_;
    return norm(Vector3{offset.x / radii_.x, offset.y / radii_.y, offset.z / radii_.z});
  }

 private:
  Vector3 radii_;
  Vector3 centre_;
};

/// Share of a crown's branchings that lie in the outer half of the ellipsoid's volume, beyond 0.79
/// of its radius.
double outer_share(const Skeleton& tree, const EllipsoidRadius& radius) {
  const double middle = std::cbrt(0.5);
  const ChildLists children(tree);
  double outer = 0.0, all = 0.0;
  for (std::size_t i = 0; i < tree.node_count(); ++i) {
    if (children.of(static_cast<std::int32_t>(i)).size() < 2) continue;
    all += 1.0;
    outer += radius(tree.positions()[i]) > middle;
  }
  return all > 0.0 ? outer / all : 0.0;
}

enum class Points { everywhere, near_envelope };

/// Fig. 21: the start settings' cloud with points beyond 0.85 of the radius alone, or as many
/// everywhere. A hollow cloud can be grown only if a node perceives across it.
double outer_share_with(const TreeParameters& parameters, Points points,
                        const ExperimentContext& context) {
  Seedling seedling = make_seedling(parameters);
  const EllipsoidRadius radius(parameters.cloud, seedling.skeleton.position(seedling.crown_root));
  std::vector<Vector3> shell;
  for (const Vector3& point : seedling.attraction_points)
    if (radius(point) > 0.85) shell.push_back(point);
  if (points == Points::near_envelope)
    seedling.attraction_points = shell;
  else  // the first of them lie everywhere, as all do
    seedling.attraction_points.resize(shell.size());
  return outer_share(grow_seedling(seedling, context).skeleton, radius);
}

void record_shell(ExperimentContext& context) {
  TreeParameters parameters;
  parameters.influence_distance = 8.0;
  parameters.kill_distance.begin = parameters.kill_distance.end = 0.5;
  parameters.iterations = 100;
  const auto record = [&](const char* name, Points points) {
    return record_trees(
        context, std::string("shell/") + name + "/outer-share", "1", [&](std::size_t number) {
          return outer_share_with(tree_of_trend(parameters, context, number), points, context);
        });
  };
  const ByTree near_envelope = record("near-envelope", Points::near_envelope);
  const ByTree everywhere = record("everywhere", Points::everywhere);
  record_trend(context, "shell/near-envelope-over-everywhere", near_envelope, everywhere);
  record_trend(context, "shell/outer-half-over-inner-half", near_envelope,
               ByTree(near_envelope.size(), 0.5));
}

/// Branchings of crowns' inner and outer halves, by edges from the crown root: their numbers, and
/// their shares of the nodes with a child. Numbers rise outwards wherever nodes do, as they do in
/// every crown here; shares need not. Returns outer less inner shares.
ByTree record_halves(ExperimentContext& context, const std::string& name,
                     const std::function<GrownTree(std::size_t)>& grow,
                     const SeedOfTree& seed_of_tree = {}) {
  ByTree inner_number, outer_number, inner_share, outer_share;
  const ByTree gain = record_trees(
      context, name + "/outward-gain", "1",
      [&](std::size_t number) {
        const GrownTree tree = grow(number);
        const std::vector<CrownPart> parts =
            crown_parts(tree.skeleton, tree.seedling.crown_root, 2);
        inner_number.push_back(static_cast<double>(parts[0].branchings));
        outer_number.push_back(static_cast<double>(parts[1].branchings));
        inner_share.push_back(parts[0].branching_share());
        outer_share.push_back(parts[1].branching_share());
        return outer_share.back() - inner_share.back();
      },
      trees_per_trend, seed_of_tree);
  record_trend(context, name + "/outer-number-over-inner", outer_number, inner_number);
  record_trend(context, name + "/outer-share-over-inner", outer_share, inner_share);
  return gain;
}

/// Sec. 3.4.4: the start settings, whose kill distance shrinks, against its first and its last
/// value from beginning to end.
void record_kill_distances(ExperimentContext& context) {
  const TreeParameters shrinking;
  TreeParameters large = shrinking, small = shrinking;
  large.kill_distance.end = large.kill_distance.begin;
  small.kill_distance.begin = small.kill_distance.end;
  const auto record = [&](const char* name, const TreeParameters& parameters) {
    return record_halves(context, std::string("kill-distance/") + name, [&](std::size_t number) {
      GrownTree tree{make_seedling(tree_of_trend(parameters, context, number))};
      tree.skeleton = grow_seedling(tree.seedling, context).skeleton;
      return tree;
    });
  };
  const ByTree with_shrinking = record("shrinking", shrinking);
  const ByTree with_large = record("always-large", large);
  const ByTree with_small = record("always-small", small);
  record_trend(context, "kill-distance/shrinking-over-always-large", with_shrinking, with_large);
  record_trend(context, "kill-distance/shrinking-over-always-small", with_shrinking, with_small);
}

/// Sec. 3.2.1: the thesis' trees and its bush.
void record_thesis_trees(ExperimentContext& context) {
  for (const char* figure :
       {"figure-40-left", "figure-43-left", "figure-44-left", "figure-46-left", "figure-51"}) {
    const std::string name = std::string("thesis-tree/") + figure;
    FullTrees trees(thesis_tree(figure), context);
    record_halves(
        context, name, [&](std::size_t) { return trees.next(); },
        [&](std::size_t number) { return trees.seed(number); });
    context.record(name + "/left-out", trees.left_out(), "trees");
  }
}

void run(ExperimentContext& context) {
  record_shell(context);
  record_kill_distances(context);
  record_thesis_trees(context);
}

}  // namespace

extern const ExperimentDescriptor outward_density;
constinit const ExperimentDescriptor outward_density{
    .id = "brzoska2019/outward-density",
    .question = "Do crowns branch more outside than inside?",
    .source = "[Brzoska2019] sec. 3.2.1, 3.4.4, fig. 21",
    .seconds = {1.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
