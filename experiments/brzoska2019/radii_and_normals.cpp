// SPDX-License-Identifier: MIT
// Radii and ring normals by the rules of the text, kept up while nodes are added and computed at
// the end.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tree/branch_mesh.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// Which nodes work out their radius and normal anew when a child is added.
enum class Update {
  parent,        ///< the new node's parent, as the sentence of sec. 5.1 says
  path_to_root,  ///< and after it every node below
};

/// A tree that is kept up node by node. Radii follow eq. 12, normals the sum of the edges to the
/// children, weighted by their radii (sec. 5.1).
class KeptUpTree {
 public:
  KeptUpTree(double tip_radius, double exponent) : tip_radius_(tip_radius), exponent_(exponent) {}

  void add(std::size_t parent, const Vector3& position, Update update) {
    const std::size_t node = positions_.size();
    positions_.push_back(position);
    parents_.push_back(parent);
    children_.emplace_back();
    radii.push_back(tip_radius_);
    normals.push_back({});
    if (node == 0) return;
    children_[parent].push_back(node);
    for (std::size_t at = parent;; at = parents_[at]) {
      work_out(at);
      if (at == 0 || update == Update::parent) break;
    }
  }

  std::size_t child_count(std::size_t node) const { return children_[node].size(); }

  std::vector<double> radii;
  std::vector<Vector3> normals;  ///< (0, 0, 0) at tips

 private:
  void work_out(std::size_t node) {
    double powers = 0.0;
    Vector3 sum;
    for (const std::size_t child : children_[node]) {
      powers += std::pow(radii[child], exponent_);
      sum = sum + radii[child] * (positions_[child] - positions_[node]);
    }
    radii[node] = std::pow(powers, 1.0 / exponent_);
    normals[node] = sum / norm(sum);
  }

  double tip_radius_, exponent_;
  std::vector<Vector3> positions_;
  std::vector<std::size_t> parents_;
  std::vector<std::vector<std::size_t>> children_;
};

KeptUpTree keep_up(const Skeleton& tree, const PlantParameters& look, Update update) {
  KeptUpTree kept(look.tip_radius, look.radius_exponent);
  kept.add(0, tree.positions()[0], update);
  for (std::size_t i = 1; i < tree.node_count(); ++i)
    kept.add(static_cast<std::size_t>(tree.parents()[i]), tree.positions()[i], update);
  return kept;
}

/// Both ways of keeping up against radii and normals that are computed once, from the tips down.
void record_updates(ExperimentContext& context, const Skeleton& tree, const PlantParameters& look) {
  const std::vector<double> radii = branch_radii(tree, look.tip_radius, look.radius_exponent);
  const std::vector<Vector3> normals = ring_normals(tree, radii, SingleChildNormal::child);
  for (const Update update : {Update::parent, Update::path_to_root}) {
    const KeptUpTree kept = keep_up(tree, look, update);
    double radius_error = 0.0, normal_error = 0.0;
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double error = std::abs(kept.radii[i] / radii[i] - 1.0);
      radius_error = std::max(radius_error, error);
      wrong += error > 1e-9;
      if (kept.child_count(i) > 0)
        normal_error = std::max(normal_error, norm(kept.normals[i] - normals[i]));
    }
    const std::string name = update == Update::parent ? "update/parent" : "update/path_to_root";
    context.record(name + "/max_radius_error", radius_error);
    context.record(name + "/wrong_radii", wrong);
    context.record(name + "/max_normal_error", normal_error);
  }
}

/// Core's default normals at nodes with several children against the weighted sum.
void record_branchings(ExperimentContext& context, const Skeleton& tree,
                       const PlantParameters& look) {
  const KeptUpTree kept = keep_up(tree, look, Update::path_to_root);
  const std::vector<Vector3> normals = ring_normals(
      tree, branch_radii(tree, look.tip_radius, look.radius_exponent), SingleChildNormal::bisector);
  std::int64_t branchings = 0;
  double error = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (kept.child_count(i) < 2) continue;
    ++branchings;
    error = std::max(error, norm(kept.normals[i] - normals[i]));
  }
  context.record("normal/branchings", branchings);
  context.record("normal/max_error", error);
}

/// Degrees between a fork's normal and its first branch, which is `ratio` times as thick as the
/// other.
double angle_to_first_deg(double ratio) {
  Skeleton fork({0, -1, 0});
  fork.append(0, {0, 0, 0});
  fork.append(1, {std::sqrt(0.75), 0.5, 0});
  fork.append(1, {-std::sqrt(0.75), 0.5, 0});
  const std::vector<double> radii{1.0, 1.0, ratio * 0.1, 0.1};
  const Vector3 normal = ring_normals(fork, radii, SingleChildNormal::bisector)[1];
  const Vector3 branch = fork.positions()[2];
  return std::atan2(norm(cross(normal, branch)), dot(normal, branch)) * 180.0 / std::numbers::pi;
}

void record_fork(ExperimentContext& context) {
  std::int64_t turns_away = 0;
  for (double ratio = 1.0; ratio < 10.0; ratio += 0.1)
    turns_away += angle_to_first_deg(ratio + 0.1) >= angle_to_first_deg(ratio);
  context.record("normal/fork/equal_branches", angle_to_first_deg(1.0), "degree");
  context.record("normal/fork/turns_away_from_thicker", turns_away);
}

/// Largest relative difference between what a node's sum of powers is and its children's.
double power_sum_error(const Skeleton& tree, double exponent, double power) {
  const std::vector<double> radii = branch_radii(tree, 0.007, exponent);
  const ChildLists children(tree);
  double error = 0.0;
  for (std::size_t node = 0; node < radii.size(); ++node) {
    const auto above = children.of(static_cast<std::int32_t>(node));
    if (above.empty()) continue;
    double sum = 0.0;
    for (const std::int32_t child : above)
      sum += std::pow(radii[static_cast<std::size_t>(child)], power);
    error = std::max(error, std::abs(sum / std::pow(radii[node], power) - 1.0));
  }
  return error;
}

/// What the ends of the range mean, and where the thesis' own plants lie.
void record_exponents(ExperimentContext& context, const Skeleton& tree) {
  context.record("exponent/2/max_area_error", power_sum_error(tree, 2.0, 2.0));
  context.record("exponent/3/max_cube_error", power_sum_error(tree, 3.0, 3.0));
  context.record("exponent/2.5/max_area_error", power_sum_error(tree, 2.5, 2.0));
  std::int64_t rows = 0, within = 0;
  for (const std::string& row : thesis_parameters().table("appendix").texts("rows")) {
    const double n = thesis_tree(row).plant.radius_exponent;
    context.record("exponent/" + row, n);
    ++rows;
    within += n >= 2.0 && n <= 3.0;
  }
  context.record("exponent/rows", rows);
  context.record("exponent/rows_from_2_to_3", within);
}

void run(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-40-left");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  context.record("update/nodes", whole(tree.node_count()));
  record_updates(context, tree, parameters.plant);
  record_branchings(context, tree, parameters.plant);
  record_fork(context);
  record_exponents(context, tree);
}

}  // namespace

extern const ExperimentDescriptor radii_and_normals;
constinit const ExperimentDescriptor radii_and_normals{
    .id = "brzoska2019/radii-and-normals",
    .question =
        "Do radii and ring normals follow the rules of the text, whenever they are "
        "computed?",
    .source = "[Brzoska2019] eq. 11, 12, sec. 3.4.4, 5.1, fig. 29",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
