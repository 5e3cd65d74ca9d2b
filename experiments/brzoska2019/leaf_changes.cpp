// SPDX-License-Identifier: MIT
// What changes about a plant when its leaves, or how finely it is drawn, are set otherwise, and
// what when nothing is set at all and the geometry is fetched again.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/random/distributions.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/plant.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

bool is_placed_alike(const Leaf& a, const Leaf& b) {
  return a.position == b.position && a.turned == b.turned;
}

/// Leaves of `few` that `many` has not, at the same place with the same turn.
std::int64_t missing_from(const std::vector<Leaf>& few, const std::vector<Leaf>& many) {
  std::map<std::array<double, 3>, const Leaf*> by_place;
  for (const Leaf& leaf : many)
    by_place[{leaf.position.x, leaf.position.y, leaf.position.z}] = &leaf;
  return std::count_if(few.begin(), few.end(), [&](const Leaf& leaf) {
    const auto found = by_place.find({leaf.position.x, leaf.position.y, leaf.position.z});
    return found == by_place.end() || !is_placed_alike(leaf, *found->second);
  });
}

void record_numbers(ExperimentContext& context, const Skeleton& tree,
                    const std::vector<double>& radii, LeafOptions options) {
  std::vector<Leaf> fewer;
  std::int64_t compared = 0, lost = 0;
  for (const double per_node : {0.4, 0.7, 1.3, 5.5, 20.0}) {
    options.per_node = per_node;
    std::vector<Leaf> leaves = make_leaves(tree, radii, options);
    compared += whole(fewer.size());
    lost += missing_from(fewer, leaves);
    fewer = std::move(leaves);
  }
  context.record("number/compared", compared);
  context.record("number/moved_or_turned", lost);
}

/// Another size, and squares instead of cross-foils: the leaves stay where they are.
void record_looks(ExperimentContext& context, const Skeleton& tree,
                  const std::vector<double>& radii, const LeafOptions& options) {
  LeafOptions larger = options;
  larger.size *= 2.0;
  larger.shape = LeafShape::square;
  const std::vector<Leaf> before = make_leaves(tree, radii, options);
  context.record("size_and_shape/compared", whole(before.size()));
  context.record("size_and_shape/moved_or_turned",
                 missing_from(before, make_leaves(tree, radii, larger)));
}

/// How many different leaves one node has to show, and what asking for more does.
void record_most_leaves(ExperimentContext& context) {
  Skeleton twig({0, 0, 0});
  twig.append(0, {0, 1, 0});
  const std::vector<double> radii{0.007, 0.007};
  std::set<std::array<double, 4>> turns;
  for (const Leaf& leaf : make_leaves(twig, radii, {.per_node = 1000.0})) {
    const Vector3& axial = leaf.turned.axial();
    turns.insert({leaf.turned.w(), axial.x, axial.y, axial.z});
  }
  context.record("most/different_leaves_at_a_node", whole(turns.size()));
  bool refused = false;
  try {
    make_leaves(twig, radii, {.per_node = 1024.0});
  } catch (const ContractViolation&) {
    refused = true;
  }
  context.record("most/more_refused", std::int64_t{refused});
}

/// Leaves as sec. 5.1 tells: made once, with place and turn, and given a size whenever geometry is
/// fetched. Core draws sizes once, so that equal settings give equal files.
class ToldLeaves {
 public:
  ToldLeaves(std::size_t nodes, std::size_t per_node, UnitStream& stream) : pools_(nodes) {
    for (auto& pool : pools_)
      for (std::size_t i = 0; i < per_node; ++i) pool.push_back(made(stream));
  }

  /// Leaves by node and number, with sizes drawn from what the stream has left.
  std::map<std::pair<std::size_t, std::size_t>, Leaf> fetch(double per_node, double mean_size,
                                                            UnitStream& stream) const {
    std::map<std::pair<std::size_t, std::size_t>, Leaf> shown;
    for (std::size_t node = 0; node < pools_.size(); ++node) {
      const bool one_more = stream.next_unit() < per_node - std::floor(per_node);
      const std::size_t count = static_cast<std::size_t>(per_node) + one_more;
      for (std::size_t i = 0; i < std::min(count, pools_[node].size()); ++i) {
        Leaf leaf = pools_[node][i];
        leaf.size = mean_size * (1.0 + 0.2 * random_normal(stream));
        shown[{node, i}] = leaf;
      }
    }
    return shown;
  }

 private:
  static Leaf made(UnitStream& stream) {
    const double share = stream.next_unit(), u1 = stream.next_unit(), u2 = stream.next_unit();
    return {{0, share, 0}, Rotation::uniform(u1, u2, stream.next_unit()), 0.0};
  }

  std::vector<std::vector<Leaf>> pools_;
};

/// Two fetches in a row: what differs.
void record_fetches(ExperimentContext& context) {
  constexpr std::size_t nodes = 1340, pool = 10;
  CounterStream stream(context.seed(), 53);
  const ToldLeaves leaves(nodes, pool, stream);
  for (const double per_node : {2.0, 0.7}) {
    const auto first = leaves.fetch(per_node, 0.7, stream);
    const auto second = leaves.fetch(per_node, 0.7, stream);
    std::int64_t in_both = 0, turned = 0, resized = 0;
    for (const auto& [key, leaf] : first) {
      const auto found = second.find(key);
      if (found == second.end()) continue;
      ++in_both;
      turned += !is_placed_alike(leaf, found->second);
      resized += leaf.size != found->second.size;
    }
    const std::string name = per_node == 2.0 ? "fetch/two_per_node" : "fetch/fraction_per_node";
    context.record(name + "/first", whole(first.size()));
    context.record(name + "/second", whole(second.size()));
    context.record(name + "/in_both", in_both);
    context.record(name + "/moved_or_turned", turned);
    context.record(name + "/other_size", resized);
  }
  context.record("fetch/more_than_the_pool", whole(leaves.fetch(50.0, 0.7, stream).size()));
  context.record("fetch/pool", whole(nodes * pool));
}

/// Core's leaves twice: nothing may differ.
void record_core_fetches(ExperimentContext& context, const Skeleton& tree,
                         const std::vector<double>& radii, const LeafOptions& options) {
  const std::vector<Leaf> first = make_leaves(tree, radii, options);
  const std::vector<Leaf> second = make_leaves(tree, radii, options);
  std::int64_t differences = first.size() != second.size();
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
    differences += !is_placed_alike(first[i], second[i]) || first[i].size != second[i].size;
  context.record("fetch/core_differences", differences);
}

/// Plants dressed in different ways from one grown skeleton.
void record_dresses(ExperimentContext& context, const Skeleton& tree, const PlantParameters& look) {
  const auto record = [&](const std::string& name, const PlantParameters& changed) {
    const Plant plant = make_plant(tree, changed);
    double area = 0.0;
    for (const Leaf& leaf : plant.leaves) area += leaf.size * leaf.size;
    context.record("dress/" + name + "/tree_hash", tree_hash(plant.skeleton));
    context.record("dress/" + name + "/branch_triangles",
                   whole(plant.branches.mesh.triangle_count()));
    context.record("dress/" + name + "/leaves", whole(plant.leaves.size()));
    context.record("dress/" + name + "/leaf_area", area, "square length");
  };
  record("as_grown", look);
  PlantParameters changed = look;
  changed.leaves.per_node *= 2.0;
  record("leaf_density", changed);
  changed = look;
  changed.leaves.size *= 2.0;
  record("leaf_size", changed);
  changed = look;
  changed.branches.circle_resolution = 8;
  record("circle_resolution", changed);
  context.record("dress/grown/tree_hash", tree_hash(tree));
}

void run(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-40-right");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  const PlantParameters& look = parameters.plant;
  const std::vector<double> radii = branch_radii(tree, look.tip_radius, look.radius_exponent);
  record_numbers(context, tree, radii, look.leaves);
  record_looks(context, tree, radii, look.leaves);
  record_most_leaves(context);
  record_fetches(context);
  record_core_fetches(context, tree, radii, look.leaves);
  record_dresses(context, tree, look);
}

}  // namespace

extern const ExperimentDescriptor leaf_changes;
constinit const ExperimentDescriptor leaf_changes{
    .id = "brzoska2019/leaf-changes",
    .question = "What changes about a plant when its leaves are set otherwise or fetched again?",
    .source = "[Brzoska2019] sec. 5.1, 5.5.2",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
