// SPDX-License-Identifier: MIT
// Section 3.4.5 word by word - every branch is rotated with all that it carries - against core's
// one pass; and what bent branches may run into.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/contract/errors.hpp"
#include "core/tree/branch_overlaps.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/pendulous_branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

using Positions = std::vector<Vector3>;

constexpr Vector3 down{0, -1, 0};

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

std::size_t index_of(std::int32_t node) {
  return static_cast<std::size_t>(node);
}

/// A node and everything above it.
std::vector<std::size_t> subtree_of(const ChildLists& children, std::size_t node) {
  std::vector<std::size_t> subtree{node};
  for (std::size_t i = 0; i < subtree.size(); ++i)
    for (const std::int32_t child : children.of(static_cast<std::int32_t>(subtree[i])))
      subtree.push_back(index_of(child));
  return subtree;
}

/// Turns a subtree about its branch's lower end by psi of eq. 13. Points straight up or down: no
/// axis, and nothing to turn.
void rotate_subtree(Positions& positions, const std::vector<std::size_t>& subtree,
                    std::size_t parent, double lambda) {
  const Vector3 pivot = positions[parent];
  const Vector3 branch = positions[subtree[0]] - pivot;
  const Vector3 axis = cross(branch, down);
  if (norm(axis) == 0.0) return;
  const double theta_deg = angle_between(branch, down) * 180.0 / std::numbers::pi;
  const double psi_deg = lambda * (1.0 - theta_deg / 180.0) * theta_deg;
  const Rotation turn = Rotation::about(axis / norm(axis), psi_deg * std::numbers::pi / 180.0);
  for (const std::size_t node : subtree) positions[node] = pivot + turn(positions[node] - pivot);
}

/// How much a rotation has changed lengths of edges and angles between successive ones, inside the
/// subtree.
struct ShapeChange {
  double length = 0.0;  ///< relative
  double angle = 0.0;   ///< radians
};

void measure(ShapeChange& change, const Positions& before, const Positions& after,
             const std::vector<std::size_t>& subtree, const Skeleton& tree) {
  const auto edge = [&](const Positions& p, std::size_t node) {
    return p[node] - p[index_of(tree.parents()[node])];
  };
  for (const std::size_t node : subtree) {
    change.length =
        std::max(change.length, std::abs(norm(edge(after, node)) / norm(edge(before, node)) - 1.0));
    if (node == subtree[0]) continue;
    const std::size_t below = index_of(tree.parents()[node]);
    change.angle =
        std::max(change.angle, std::abs(angle_between(edge(after, node), edge(after, below)) -
                                        angle_between(edge(before, node), edge(before, below))));
  }
}

enum class Order { from_root, from_tips };

/// The method as told: one rotation per branch from the first order on.
Positions bend_branch_by_branch(const Skeleton& tree, const PendulousBranches& pendulous,
                                Order order, ShapeChange& change) {
  const ChildLists children(tree);
  const std::vector<std::int32_t> depths = node_depths(tree);
  Positions positions(tree.positions().begin(), tree.positions().end());
  for (std::size_t i = 1; i < depths.size(); ++i) {
    const std::size_t node = order == Order::from_root ? i : depths.size() - i;
    if (depths[node] < pendulous.first_order) continue;
    const std::vector<std::size_t> subtree = subtree_of(children, node);
    const Positions before = order == Order::from_root ? positions : Positions{};
    rotate_subtree(positions, subtree, index_of(tree.parents()[node]), pendulous.intensity);
    if (order == Order::from_root) measure(change, before, positions, subtree, tree);
  }
  return positions;
}

double largest_distance(const Positions& positions, const Skeleton& tree) {
  double largest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    largest = std::max(largest, norm(positions[i] - tree.positions()[i]));
  return largest;
}

void record_subtrees(ExperimentContext& context, const Skeleton& tree,
                     const PendulousBranches& pendulous) {
  const Skeleton bent = bend_branches(tree, pendulous);
  ShapeChange change, unused;
  const Positions told = bend_branch_by_branch(tree, pendulous, Order::from_root, change);
  context.record("subtree/max_length_change", change.length);
  context.record("subtree/max_angle_change", change.angle, "radian");
  context.record("subtree/difference_from_one_pass", largest_distance(told, bent), "length");
  context.record("subtree/moved", largest_distance(told, tree), "length");
  const Positions reversed = bend_branch_by_branch(tree, pendulous, Order::from_tips, unused);
  context.record("subtree/difference_if_tips_come_first", largest_distance(reversed, bent),
                 "length");
}

/// A branch of two edges in one direction, bent; nothing if that gives no positions.
std::optional<Skeleton> bent_branch(const Vector3& direction) {
  Skeleton branch({0, 0, 0});
  branch.append(0, direction);
  branch.append(1, 2.0 * direction);
  try {
    return bend_branches(branch, {.intensity = 0.8, .first_order = 1});
  } catch (const ContractViolation&) {  // a skeleton refuses what is not finite
    return std::nullopt;
  }
}

/// Branches straight up and straight down, and others next to them.
void record_axis(ExperimentContext& context) {
  std::int64_t not_finite = 0, vertical_moves = 0;
  double largest_turn = 0.0;
  for (const double upward : {1.0, -1.0})
    for (const double aside : {0.0, 1e-300, 1e-160, 1e-20, 1e-9}) {
      const Vector3 direction{aside, upward, 0};
      const std::optional<Skeleton> bent = bent_branch(direction);
      not_finite += !bent;
      for (std::size_t i = 1; bent && i < 3; ++i) {
        const Vector3 edge = bent->positions()[i] - bent->positions()[i - 1];
        if (aside == 0.0) vertical_moves += !(edge == direction);
        largest_turn = std::max(largest_turn, angle_between(edge, direction));
      }
    }
  context.record("axis/not_finite", not_finite);
  context.record("axis/vertical_moves", vertical_moves);
  context.record("axis/largest_turn_beside_vertical", largest_turn, "radian");
}

/// Pairs of edges whose tubes meet although so many edges at least lie between them.
std::int64_t meeting_pairs(const Skeleton& tree, const std::vector<double>& radii,
                           std::int32_t least_edges_between) {
  const std::vector<BranchOverlap> overlaps = branch_overlaps(tree, radii);
  return std::count_if(overlaps.begin(), overlaps.end(), [&](const BranchOverlap& overlap) {
    return overlap.edges_between >= least_edges_between;
  });
}

/// A long branch above a short one: bent, it comes down upon it.
void record_two_branches(ExperimentContext& context) {
  Skeleton tree({0, 0, 0});
  for (int y = 1; y <= 4; ++y) tree.append(y - 1, {0, static_cast<double>(y), 0});
  std::int32_t last = 1;
  for (int x = 1; x <= 2; ++x) last = tree.append(last, {static_cast<double>(x), 1, 0});
  last = 4;
  for (int x = 1; x <= 4; ++x) last = tree.append(last, {static_cast<double>(x), 4, 0});
  const std::vector<double> radii = branch_radii(tree, 0.007, 1.9);
  const Skeleton bent = bend_branches(tree, {.intensity = 0.8, .first_order = 5});
  context.record("overlap/two_branches/unbent", meeting_pairs(tree, radii, 1));
  context.record("overlap/two_branches/bent", meeting_pairs(bent, radii, 1));
}

void run(ExperimentContext& context) {
  record_axis(context);
  record_two_branches(context);
  const TreeParameters parameters = thesis_tree("figure-43-middle");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  record_subtrees(context, tree, parameters.plant.pendulous);
  const std::vector<double> radii =
      branch_radii(tree, parameters.plant.tip_radius, parameters.plant.radius_exponent);
  // Next to a branching tubes meet wherever they go, so only edges well apart count.
  constexpr std::int32_t least_edges_between = 10;
  PendulousBranches pendulous = parameters.plant.pendulous;
  for (const int tenths : {0, 4, 8}) {
    pendulous.intensity = tenths / 10.0;
    context.record("overlap/figure-43/lambda-" + std::to_string(tenths),
                   meeting_pairs(bend_branches(tree, pendulous), radii, least_edges_between));
  }
}

}  // namespace

extern const ExperimentDescriptor bending;
constinit const ExperimentDescriptor bending{
    .id = "brzoska2019/bending",
    .question = "Does bending turn branches as rigid parts, and what may they run into?",
    .source = "[Brzoska2019] sec. 3.4.5, 6.2, fig. 22, 43",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
