// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/growth_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

using oracles::brzoska2019::GridJudge;
using oracles::brzoska2019::GrownTree;
using oracles::brzoska2019::Point;

Point in_oracle_words(const Vector3& v) {
  return {v.x, v.y, v.z};
}

std::vector<Point> positions(std::span<const SearchableNode> nodes) {
  std::vector<Point> points;
  for (const SearchableNode& node : nodes) points.push_back(in_oracle_words(node.position));
  return points;
}

std::string hash_of(const Seedling& seedling, const GrownTree& tree) {
  Skeleton whole = seedling.skeleton;
  const std::size_t start =
      seedling.skeleton.node_count() - static_cast<std::size_t>(seedling.crown_root);
  for (std::size_t i = start; i < tree.nodes.size(); ++i)
    whole.append(seedling.crown_root + tree.parents[i],
                 {tree.nodes[i].x, tree.nodes[i].y, tree.nodes[i].z});
  return tree_hash(whole);
}

class LiteralJudge final : public GrowthJudge {
 public:
  explicit LiteralJudge(const GrowthOracle& oracle) : oracle_(oracle) {}

  void restart() override { passes_ = removals_ = 0; }

  std::span<const int> associate(std::span<const SearchableNode>) override {
    const auto& passes = oracle_.tree().passes;
    if (passes_ >= passes.size()) return {};
    return passes[passes_++].nearest;
  }

  std::vector<int> remove(std::span<const SearchableNode>, double, bool& expected) override {
    const auto& removals = oracle_.tree().removals;
    expected = removals_ < removals.size();
    return expected ? removals[removals_++] : std::vector<int>{};
  }

  std::string tree_hash() const override { return oracle_.hash(); }
  std::string name() const override { return "literal oracle"; }

 private:
  const GrowthOracle& oracle_;
  std::size_t passes_ = 0;
  std::size_t removals_ = 0;
};

/// The nearest node of a few points, found by comparing each with every node: nothing to get wrong,
/// and nothing shared with the grid.
class LiteralSample {
 public:
  LiteralSample(const GridJudge& judge, double theta_rad, double d_i, std::uint64_t seed,
                std::size_t count)
      : judge_(judge),
        cosine_(std::cos(theta_rad / 2)),
        d_i_(d_i),
        all_around_(theta_rad / 2 >= std::numbers::pi) {
    const std::size_t points = judge.attraction_points().size();
    CounterStream stream(seed, 0);
    for (std::size_t i = 0; i < std::min(count, points); ++i)
      sample_.push_back({points <= count ? i : index_below(points, stream)});
  }

  void add_nodes() {
    list_new_nodes();
    for (Sampled& sampled : sample_)
      for (std::size_t block = 0; block < x_.size(); block += nodes_in_block)
        offer_block(sampled, block, std::min(block + nodes_in_block, x_.size()));
    nodes_ += x_.size();
  }

  /// The first sampled live point whose answer differs; -1 if none does.
  std::int64_t first_difference(const std::vector<int>& nearest) const {
    for (const Sampled& sampled : sample_)
      if (!sampled.removed && nearest[sampled.point] != sampled.node)
        return static_cast<std::int64_t>(sampled.point);
    return -1;
  }

  void remove(const std::vector<int>& points) {
    for (Sampled& sampled : sample_)
      sampled.removed = sampled.removed || std::binary_search(points.begin(), points.end(),
                                                              static_cast<int>(sampled.point));
  }

 private:
  struct Sampled {
    std::size_t point;
    int node = -1;
    double squared = 0.0;
    bool removed = false;
  };

  static std::size_t index_below(std::size_t count, CounterStream& stream) {
    return std::min(static_cast<std::size_t>(stream.next_unit() * static_cast<double>(count)),
                    count - 1);
  }

  void list_new_nodes() {
    const auto& nodes = judge_.nodes();
    x_.clear();
    y_.clear();
    z_.clear();
    for (std::size_t v = nodes_; v < nodes.size(); ++v) {
      x_.push_back(nodes[v].x);
      y_.push_back(nodes[v].y);
      z_.push_back(nodes[v].z);
    }
  }

  void offer_block(Sampled& sampled, std::size_t begin, std::size_t end) const {
    if (sampled.removed || all_too_far(sampled, begin, end)) return;
    for (std::size_t i = begin; i < end; ++i) offer(sampled, nodes_ + i);
  }

  /// Whether offer() would turn all of them away for their distance. Without a branch, so that it
  /// becomes vector instructions: ten million points have billions of pairs per iteration.
  bool all_too_far(const Sampled& sampled, std::size_t begin, std::size_t end) const {
    const auto p = judge_.attraction_points()[sampled.point];
    double limit = d_i_ * d_i_;
    if (sampled.node >= 0) limit = std::min(limit, sampled.squared);
    std::int64_t near = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared =
          oracles::brzoska2019::equation_24(p, {.x = x_[i], .y = y_[i], .z = z_[i]});
      near |= static_cast<std::int64_t>(!(squared > limit));
    }
    return near == 0;
  }

  void offer(Sampled& sampled, std::size_t node) const {
    using namespace oracles::brzoska2019;
    const Point p = judge_.attraction_points()[sampled.point];
    const Point v = judge_.nodes()[node];
    const double squared = equation_24(p, v);
    if (squared > d_i_ * d_i_ || (sampled.node >= 0 && squared >= sampled.squared)) return;
    if (!all_around_ &&
        !(scalar_product(judge_.directions()[node], minus(p, v)) >= cosine_ * std::sqrt(squared)))
      return;
    sampled.node = static_cast<int>(node);
    sampled.squared = squared;
  }

  static constexpr std::size_t nodes_in_block = 64;

  const GridJudge& judge_;
  double cosine_;
  double d_i_;
  bool all_around_;
  std::vector<Sampled> sample_;
  std::size_t nodes_ = 0;          ///< offered so far
  std::vector<double> x_, y_, z_;  ///< of the nodes that are new
};

class SampledGridJudge final : public GrowthJudge {
 public:
  SampledGridJudge(const Seedling& seedling, std::uint64_t seed, std::size_t sampled_points)
      : seedling_(seedling), seed_(seed), sampled_points_(sampled_points) {}

  void restart() override {
    const GrowthParameters& growth = seedling_.growth;
    const bool after = growth.variant.perception_test == PerceptionTest::after_search;
    const double theta = after ? 2 * std::numbers::pi : growth.perception_angle_rad;
    std::vector<Point> points;
    points.reserve(seedling_.attraction_points.size());
    for (const Vector3& point : seedling_.attraction_points)
      points.push_back(in_oracle_words(point));
    sample_.reset();
    judge_ = std::make_unique<GridJudge>(std::move(points), growth.influence_distance, theta);
    sample_ = std::make_unique<LiteralSample>(*judge_, theta, growth.influence_distance, seed_,
                                              sampled_points_);
  }

  std::span<const int> associate(std::span<const SearchableNode> new_nodes) override {
    std::vector<Point> directions;
    for (const SearchableNode& node : new_nodes)
      directions.push_back(in_oracle_words(node.direction));
    const std::vector<int>& nearest = judge_->associate(positions(new_nodes), directions);
    sample_->add_nodes();
    if (const std::int64_t point = sample_->first_difference(nearest); point >= 0)
      throw ContractViolation(fmt::format(
          "the judges disagree on point {}: the grid oracle or the plain loop is wrong", point));
    return nearest;
  }

  std::vector<int> remove(std::span<const SearchableNode> killers, double distance,
                          bool& expected) override {
    expected = true;
    std::vector<int> removed = judge_->remove(positions(killers), distance);
    sample_->remove(removed);
    return removed;
  }

  std::string tree_hash() const override { return {}; }
  std::string name() const override {
    return fmt::format("grid oracle, {} points of it by comparing every node", sampled_points_);
  }

 private:
  const Seedling& seedling_;
  std::uint64_t seed_;
  std::size_t sampled_points_;
  std::unique_ptr<GridJudge> judge_;
  std::unique_ptr<LiteralSample> sample_;
};

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

std::unique_ptr<GrowthJudge> make_literal_judge(const GrowthOracle& oracle) {
  return std::make_unique<LiteralJudge>(oracle);
}

std::unique_ptr<GrowthJudge> make_grid_judge(const Seedling& seedling, std::uint64_t seed,
                                             std::size_t sampled_points) {
  return std::make_unique<SampledGridJudge>(seedling, seed, sampled_points);
}

}  // namespace phytobench
