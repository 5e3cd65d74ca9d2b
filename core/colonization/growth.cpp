// SPDX-License-Identifier: MIT
#include "core/colonization/growth.hpp"

#include <chrono>
#include <memory>
#include <numbers>
#include <utility>

#include "core/colonization/growth_step.hpp"
#include "core/colonization/rest.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time of its scope to a counter of seconds.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
  ~PhaseTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& seconds_;
  Clock::time_point start_;
};

LargeVector<SearchableNode> as_large(const std::vector<SearchableNode>& nodes) {
  return {nodes.begin(), nodes.end()};
}

class GrowthLoop {
 public:
  GrowthLoop(const Seedling& seedling, NearestNodeEngine& engine, const GrowthRun& run)
      : seedling_(seedling),
        nodes_(as_large(start_nodes(seedling))),
        rest_(made_rest(engine)),
        engine_(rest_ ? rest_->engine() : engine),
        run_(run),
        step_(seedling.growth, run.threads) {
    result_.skeleton = seedling.skeleton;
    reserve(seedling.attraction_points.size());
  }

  GrowthResult run() {
    {
      PhaseTimer timer(result_.seconds.total);
      engine_.reset(seedling_.attraction_points, engine_setup());
      result_.stop_reason = iterate();
    }
    result_.work = engine_.counters();
    result_.live_points = engine_.live_points();
    return std::move(result_);
  }

 private:
  /// Only if nodes can come to rest: everybody else's engine works as it is.
  std::unique_ptr<Rest> made_rest(NearestNodeEngine& engine) const {
    const std::int32_t iterations = seedling_.growth.limits.rest_iterations;
    if (iterations == GrowthLimits::unlimited) return nullptr;
    return std::make_unique<Rest>(iterations, nodes_.size(), engine);
  }

  /// Trees rarely have more nodes than attraction points, and pages that nobody touches cost
  /// nothing; copying and clearing memory as lists double costs more than growth itself.
  void reserve(std::size_t node_count) {
    nodes_.reserve(node_count);
    result_.skeleton.reserve(node_count);
    step_.reserve(node_count);
  }

  EngineSetup engine_setup() const {
    const GrowthParameters& growth = seedling_.growth;
    const bool angle_in_search = growth.variant.perception_test == PerceptionTest::during_search;
    return {.influence_distance =
                largest_within(growth.influence_distance, growth.variant.influence_boundary),
            .perception_half_angle_rad =
                angle_in_search ? 0.5 * growth.perception_angle_rad : std::numbers::pi,
            .search_filter = run_.options.point_filter,
            // Only a deferred removal walks the box-filtered loop ([Brzoska2019] sec. 5.2.2).
            .kill_filter = deferred() ? run_.options.point_filter : PointFilter::none,
            .associations = growth.iterations,
            .threads = run_.threads,
            .count_work = run_.count_work};
  }

  bool deferred() const { return run_.options.kill_timing == KillTiming::deferred; }

  StopReason iterate() {
    for (int i = 0; i < seedling_.growth.iterations; ++i) {
      PassStatistics pass{.iteration = i};
      if (deferred()) {
        kill_before_association(i, pass);
        if (i > 0 && engine_.live_points() == 0) {
          // This iteration never runs; its removal belongs to the one it was put off from.
          result_.passes.back().removed_points += pass.removed_points;
          result_.passes.back().kill_evaluations += pass.kill_evaluations;
          return StopReason::no_points_left;
        }
      }
      const GrowthStep::Counts counts = associate_and_grow(pass);
      if (!deferred() && (pass.new_nodes > 0 || rest_)) kill(i, kill_distance(i), pass);
      result_.passes.push_back(pass);
      if (run_.observer && !run_.observer(pass)) return StopReason::interrupted;
      const bool may_change = rest_ && counts.assigned_points > 0;
      if (pass.new_nodes == 0 && !may_change) return why_nothing_grew(pass);
      if (!deferred() && engine_.live_points() == 0) return StopReason::no_points_left;
    }
    return StopReason::iteration_limit;
  }

  static StopReason why_nothing_grew(const PassStatistics& pass) {
    if (pass.searchable_nodes == 0) return StopReason::every_node_rests;
    if (pass.associated_points == 0) return StopReason::no_point_in_range;
    return pass.refused_children > 0 ? StopReason::no_child_allowed : StopReason::no_new_node;
  }

  GrowthStep::Counts associate_and_grow(PassStatistics& pass) {
    const WorkCounters before = engine_.counters();
    pass.live_points = engine_.live_points();
    pass.searchable_nodes = nodes_.size() - (rest_ ? rest_->resting() : 0);
    const Assignment assignment = associate();
    const WorkCounters after = engine_.counters();
    pass.queried_points = after.queries - before.queries;
    pass.search_evaluations = after.search_evaluations - before.search_evaluations;

    PhaseTimer timer(result_.seconds.growth);
    const GrowthStep::Counts counts = step_.grow(seedling_.attraction_points, assignment,
                                                 seedling_.crown_root, nodes_, result_.skeleton);
    pass.associated_points = counts.associated_points;
    pass.suppressed_repeats = counts.suppressed_repeats;
    pass.refused_children = counts.refused_children;
    pass.new_nodes = nodes_.size() - known_to_engine_;
    if (rest_) rest_->note(result_.skeleton, seedling_.crown_root, pass.new_nodes);
    return counts;
  }

  Assignment associate() {
    PhaseTimer timer(result_.seconds.association);
    const std::size_t known = std::exchange(known_to_engine_, nodes_.size());
    return engine_.associate(std::span<const SearchableNode>(nodes_).subspan(known));
  }

  /// The removal that option d has put off: that of iteration i - 1.
  void kill_before_association(int i, PassStatistics& pass) {
    const GrowthVariant& variant = seedling_.growth.variant;
    if (i == 0) {
      if (variant.deferred_first_pass == DeferredFirstPass::kill) kill(i, kill_distance(0), pass);
      return;
    }
    const bool previous =
        variant.deferred_kill_distance == DeferredKillDistance::previous_iteration;
    kill(i - 1, kill_distance(previous ? i - 1 : i), pass);
  }

  /// Removes the points near the nodes that grew in iteration i (all nodes the engine has not seen
  /// yet).
  void kill(int i, double distance, PassStatistics& pass) {
    PhaseTimer timer(result_.seconds.kill);
    const std::uint64_t before = engine_.counters().kill_evaluations;
    pass.removed_points += engine_.kill(killers(i), distance).size();
    pass.kill_evaluations += engine_.counters().kill_evaluations - before;
  }

  /// The newest nodes; after iteration 0 also, once, the start nodes that kill.
  std::span<const SearchableNode> killers(int i) {
    const std::span<const SearchableNode> all(nodes_);
    if (i > 0) return all.subspan(known_to_engine_);
    if (seedling_.growth.variant.start_killers == StartKillers::crown_stem_too) return all;
    const std::size_t start_count =
        seedling_.skeleton.node_count() - static_cast<std::size_t>(seedling_.crown_root);
    first_killers_.assign(1, all.front());
    const auto grown = all.subspan(start_count);
    first_killers_.insert(first_killers_.end(), grown.begin(), grown.end());
    return first_killers_;
  }

  double kill_distance(int i) const {
    const GrowthParameters& growth = seedling_.growth;
    return largest_within(growth.kill_distance.at(i, growth.iterations),
                          growth.variant.kill_boundary);
  }

  const Seedling& seedling_;
  LargeVector<SearchableNode> nodes_;
  std::unique_ptr<Rest> rest_;  // only if nodes can come to rest
  NearestNodeEngine& engine_;
  const GrowthRun& run_;
  GrowthStep step_;
  std::vector<SearchableNode> first_killers_;
  std::size_t known_to_engine_ = 0;  // nodes handed to associate() so far
  GrowthResult result_;
};

}  // namespace

std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::iteration_limit:
      return "iteration_limit";
    case StopReason::no_points_left:
      return "no_points_left";
    case StopReason::no_point_in_range:
      return "no_point_in_range";
    case StopReason::no_new_node:
      return "no_new_node";
    case StopReason::no_child_allowed:
      return "no_child_allowed";
    case StopReason::every_node_rests:
      return "every_node_rests";
    case StopReason::interrupted:
      return "interrupted";
  }
  return "unknown";
}

std::vector<SearchableNode> start_nodes(const Seedling& seedling) {
  const Skeleton& skeleton = seedling.skeleton;
  const auto root = static_cast<std::size_t>(seedling.crown_root);
  std::vector<SearchableNode> nodes;
  nodes.push_back({skeleton.positions()[root], seedling.crown_root_direction});
  for (std::size_t i = root + 1; i < skeleton.node_count(); ++i) {
    const Vector3 edge = skeleton.positions()[i] - skeleton.position(skeleton.parents()[i]);
    nodes.push_back({skeleton.positions()[i], edge / norm(edge)});
  }
  return nodes;
}

GrowthResult grow_crown(const Seedling& seedling, NearestNodeEngine& engine, const GrowthRun& run) {
  const GrowthParameters& growth = seedling.growth;
  const double reach = largest_within(growth.influence_distance, growth.variant.influence_boundary);
  for (const double kill : {growth.kill_distance.begin, growth.kill_distance.end})
    PHYTOBENCH_EXPECT(largest_within(kill, growth.variant.kill_boundary) <= reach);
  return GrowthLoop(seedling, engine, run).run();
}

}  // namespace phytobench
