// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/checked_growth.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "core/nearest_node/plugin/plugin_engine.hpp"

namespace phytobench {

namespace {

/// Thrown out of the growth loop at the first wrong answer.
struct Disagreement {
  std::string what;
};

/// Passes every call on and compares the answers with the judge's.
class CheckingEngine final : public NearestNodeEngine {
 public:
  CheckingEngine(NearestNodeEngine& inner, GrowthJudge& judge) : inner_(inner), judge_(judge) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    points_ = points;
    judge_.restart();
    inner_.reset(points, setup);
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    for (const SearchableNode& node : new_nodes) nodes_.push_back(node.position);
    const Assignment answer = inner_.associate(new_nodes);
    const std::span<const int> truth = judge_.associate(new_nodes);
    if (truth.size() != points_.size())
      throw Disagreement{fmt::format("iteration {}: growth should have ended before", iteration_)};
    if (answer.node.size() != points_.size())
      throw Disagreement{
          fmt::format("iteration {}: the answer does not cover every point", iteration_)};
    for (std::size_t point = 0; point < points_.size(); ++point)
      compare(answer, point, truth[point]);
    ++iteration_;
    return answer;
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const auto removed = inner_.kill(killers, distance);
    bool expected = false;
    const std::vector<int> truth = judge_.remove(killers, distance, expected);
    if (!expected) throw Disagreement{fmt::format("removal {}: there should be none", removals_)};
    std::vector<PointIndex> ascending(removed.begin(), removed.end());
    std::sort(ascending.begin(), ascending.end());
    if (!std::equal(ascending.begin(), ascending.end(), truth.begin(), truth.end()))
      throw Disagreement{
          fmt::format("removal {}: {} points removed, the judge removed {} (or others)", removals_,
                      removed.size(), truth.size())};
    ++removals_;
    return removed;
  }

  std::size_t live_points() const override { return inner_.live_points(); }
  WorkCounters counters() const override { return inner_.counters(); }

 private:
  void compare(const Assignment& answer, std::size_t point, NodeIndex expected) const {
    const NodeIndex given = answer.node[point];
    const bool listed = answer.associated.contains(static_cast<PointIndex>(point));
    if (given == expected && listed == (given != no_node)) return;
    if (given == expected)
      throw Disagreement{fmt::format("iteration {}, point {}: has node {}, but is {} as associated",
                                     iteration_, point, given, listed ? "listed" : "not listed")};
    throw Disagreement{fmt::format("iteration {}, point {}: {}, the judge has {}", iteration_,
                                   point, described(point, given), described(point, expected))};
  }

  /// The distance is computed here: an engine cannot vouch for itself.
  std::string described(std::size_t point, NodeIndex node) const {
    if (node == no_node) return "no node";
    if (node < 0 || static_cast<std::size_t>(node) >= nodes_.size())
      return fmt::format("node {}, which does not exist", node);
    return fmt::format("node {} at squared distance {}", node,
                       squared_distance(points_[point], nodes_[static_cast<std::size_t>(node)]));
  }

  NearestNodeEngine& inner_;
  GrowthJudge& judge_;
  std::span<const Vector3> points_;
  std::vector<Vector3> nodes_;
  std::size_t iteration_ = 0;
  std::size_t removals_ = 0;
};

}  // namespace

CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           GrowthJudge& judge, const GrowthRun& run) {
  PHYTOBENCH_EXPECT(engine.built());
  const auto inner = engine.create();
  CheckingEngine checking(*inner, judge);
  CheckedGrowth checked;
  try {
    checked.result = grow_crown(seedling, checking, run);
  } catch (const Disagreement& disagreement) {
    checked.disagreement = disagreement.what;
    return checked;
  } catch (const PluginMisbehaved& misbehaved) {
    checked.disagreement = misbehaved.what();
    return checked;
  }
  const std::string hash = tree_hash(checked.result.skeleton);
  if (!judge.tree_hash().empty() && hash != judge.tree_hash())
    checked.disagreement = "every assignment agrees, but the tree is another";
  else
    checked.verified = VerifiedRun(engine, seedling, hash, run);
  return checked;
}

CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           const GrowthOracle& oracle, const GrowthRun& run) {
  return grow_checked(engine, seedling, *make_literal_judge(oracle), run);
}

GrowthResult VerifiedRun::grow() const {
  const auto instance = engine_->create();
  GrowthRun run = run_;
  run.count_work = false;
  GrowthResult result = grow_crown(*seedling_, *instance, run);
  if (tree_hash(result.skeleton) == hash_) return result;
  const std::string what = "grew another tree while it was timed than while it was checked";
  if (dynamic_cast<const PluginEngine*>(instance.get()) != nullptr) throw PluginMisbehaved(what);
  throw ContractViolation("engine " + std::string(engine_->name) + " " + what);
}

}  // namespace phytobench
