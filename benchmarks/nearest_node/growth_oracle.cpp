// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/growth_oracle.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

using oracles::brzoska2019::GrownTree;
using oracles::brzoska2019::Point;

Point in_oracle_words(const Vector3& v) {
  return {v.x, v.y, v.z};
}

/// Thrown out of the growth loop at the first wrong answer.
struct Disagreement {
  std::string what;
};

/// Passes every call on and compares the answers with the oracle's.
class CheckingEngine final : public NearestNodeEngine {
 public:
  CheckingEngine(NearestNodeEngine& inner, const GrownTree& truth) : inner_(inner), truth_(truth) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    points_ = points;
    inner_.reset(points, setup);
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    for (const SearchableNode& node : new_nodes) nodes_.push_back(node.position);
    const Assignment answer = inner_.associate(new_nodes);
    if (iteration_ >= truth_.passes.size())
      throw Disagreement{fmt::format("iteration {}: the oracle had stopped before it", iteration_)};
    if (answer.node.size() != points_.size())
      throw Disagreement{
          fmt::format("iteration {}: the answer does not cover every point", iteration_)};
    for (std::size_t point = 0; point < points_.size(); ++point) compare(answer, point);
    ++iteration_;
    return answer;
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const auto removed = inner_.kill(killers, distance);
    if (removals_ >= truth_.removals.size())
      throw Disagreement{fmt::format("removal {}: the oracle made none", removals_)};
    const auto& expected = truth_.removals[removals_];
    std::vector<PointIndex> ascending(removed.begin(), removed.end());
    std::sort(ascending.begin(), ascending.end());
    if (!std::equal(ascending.begin(), ascending.end(), expected.begin(), expected.end()))
      throw Disagreement{
          fmt::format("removal {}: {} points removed, the oracle removed {} (or others)", removals_,
                      removed.size(), expected.size())};
    ++removals_;
    return removed;
  }

  std::size_t live_points() const override { return inner_.live_points(); }
  WorkCounters counters() const override { return inner_.counters(); }

 private:
  void compare(const Assignment& answer, std::size_t point) const {
    const NodeIndex given = answer.node[point];
    const NodeIndex expected = truth_.passes[iteration_].nearest[point];
    const bool listed = answer.associated.contains(static_cast<PointIndex>(point));
    if (given == expected && listed == (given != no_node)) return;
    if (given == expected)
      throw Disagreement{fmt::format("iteration {}, point {}: has node {}, but is {} as associated",
                                     iteration_, point, given, listed ? "listed" : "not listed")};
    const bool known = given >= no_node && given < static_cast<NodeIndex>(nodes_.size());
    throw Disagreement{fmt::format(
        "iteration {}, point {}: node {} at squared distance {}, the oracle has node {} at {}",
        iteration_, point, given, known ? distance(point, given) : -1.0, expected,
        distance(point, expected))};
  }

  double distance(std::size_t point, NodeIndex node) const {
    if (node == no_node) return 0.0;
    return squared_distance(points_[point], nodes_[static_cast<std::size_t>(node)]);
  }

  NearestNodeEngine& inner_;
  const GrownTree& truth_;
  std::span<const Vector3> points_;
  std::vector<Vector3> nodes_;
  std::size_t iteration_ = 0;
  std::size_t removals_ = 0;
};

std::string hash_of(const Seedling& seedling, const GrownTree& tree) {
  Skeleton whole = seedling.skeleton;
  const std::size_t start =
      seedling.skeleton.node_count() - static_cast<std::size_t>(seedling.crown_root);
  for (std::size_t i = start; i < tree.nodes.size(); ++i)
    whole.append(seedling.crown_root + tree.parents[i],
                 {tree.nodes[i].x, tree.nodes[i].y, tree.nodes[i].z});
  return tree_hash(whole);
}

}  // namespace

oracles::brzoska2019::GrowthProblem oracle_problem(const Seedling& seedling) {
  const GrowthParameters& growth = seedling.growth;
  const GrowthVariant& variant = growth.variant;
  oracles::brzoska2019::GrowthProblem problem;
  for (const Vector3& point : seedling.attraction_points)
    problem.attraction_points.push_back(in_oracle_words(point));
  for (const SearchableNode& node : start_nodes(seedling)) {
    problem.start_nodes.push_back(in_oracle_words(node.position));
    problem.start_directions.push_back(in_oracle_words(node.direction));
    problem.start_parents.push_back(static_cast<int>(problem.start_parents.size()) - 1);
  }
  problem.iterations = growth.iterations;
  problem.D = growth.step_length;
  problem.d_i = growth.influence_distance;
  problem.theta_rad = growth.perception_angle_rad;
  problem.g = in_oracle_words(growth.tropism);
  problem.d_c = [schedule = growth.kill_distance, n = growth.iterations](int i) {
    using namespace oracles::brzoska2019;
    const auto form = schedule.interpolation == KillInterpolation::linear ? equation_17_as_printed
                                                                          : equation_17_corrected;
    return form(schedule.begin, schedule.end, schedule.sigmoid_begin, schedule.sigmoid_end, n, i);
  };
  problem.departures = {
      .normalise_before_tropism = variant.tropism_order == TropismOrder::after_normalising,
      .sum_raw_vectors = variant.attraction_sum == AttractionSum::raw_vectors,
      .cone_after_search = variant.perception_test == PerceptionTest::after_search,
      .no_repeat_guard = variant.repeat_guard == RepeatGuard::off,
      .crown_stem_kills = variant.start_killers == StartKillers::crown_stem_too};
  return problem;
}

GrowthOracle::GrowthOracle(const Seedling& seedling)
    : tree_(oracles::brzoska2019::grow(oracle_problem(seedling))),
      hash_(hash_of(seedling, tree_)) {}

CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           const GrowthOracle& oracle, const GrowthRun& run) {
  PHYTOBENCH_EXPECT(engine.built());
  const auto inner = engine.create();
  CheckingEngine checking(*inner, oracle.tree());
  CheckedGrowth checked;
  try {
    checked.result = grow_crown(seedling, checking, run);
  } catch (const Disagreement& disagreement) {
    checked.disagreement = disagreement.what;
    return checked;
  }
  if (tree_hash(checked.result.skeleton) != oracle.hash())
    checked.disagreement = "every assignment agrees, but the tree is another";
  else
    checked.verified = VerifiedRun(engine, seedling, oracle.hash(), run);
  return checked;
}

GrowthResult VerifiedRun::grow() const {
  const auto instance = engine_->create();
  GrowthRun run = run_;
  run.count_work = false;
  GrowthResult result = grow_crown(*seedling_, *instance, run);
  if (tree_hash(result.skeleton) != hash_)
    throw ContractViolation("engine " + std::string(engine_->name) +
                            " grew another tree while it was timed than while it was checked");
  return result;
}

}  // namespace phytobench
