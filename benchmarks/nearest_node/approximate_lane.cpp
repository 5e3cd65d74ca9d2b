// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/approximate_lane.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

/// The bits of the parent's x, y, z, then of the child's.
using Edge = std::array<std::uint64_t, 6>;

Edge edge_between(const Vector3& parent, const Vector3& child) {
  return std::bit_cast<Edge>(std::array{parent.x, parent.y, parent.z, child.x, child.y, child.z});
}

/// Each edge once, ascending.
std::vector<Edge> edges_of(const Skeleton& skeleton) {
  std::vector<Edge> edges;
  edges.reserve(skeleton.edge_count());
  for (std::size_t child = 0; child < skeleton.node_count(); ++child) {
    const std::int32_t parent = skeleton.parents()[child];
    if (parent != Skeleton::no_parent)
      edges.push_back(edge_between(skeleton.position(parent), skeleton.positions()[child]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

GrowthResult grown(const EngineDescriptor& engine, const Seedling& seedling,
                   const std::string& option, int threads) {
  const auto instance = engine.create();
  return grow_crown(
      seedling, *instance,
      {.options = loop_options_named(option), .threads = threads, .count_work = false});
}

class Lane {
 public:
  Lane(const Workload& workload, const EngineDescriptor& exact, int threads,
       const std::function<void(const std::string&)>& show_progress)
      : seedling_(workload.seedling),
        exact_(exact),
        threads_(threads),
        show_progress_(show_progress) {}

  std::vector<ApproximateEntry> run(const std::vector<std::string>& options, int rounds) {
    for (const EngineDescriptor& engine : approximate_engines())
      for (const std::string& option : options)
        entries_.push_back({.engine = &engine, .option = option});
    for (const std::string& option : options) count_wrong_answers(option);
    for (int round = 0; round < rounds; ++round) time_round(round, rounds);
    return std::move(entries_);
  }

 private:
  void progress(const std::string& what) const {
    if (show_progress_) show_progress_(what);
  }

  void count_wrong_answers(const std::string& option) {
    if (std::none_of(entries_.begin(), entries_.end(),
                     [](const ApproximateEntry& entry) { return entry.engine->built(); }))
      return;
    progress("recording the exact growth, option " + option);
    const GrowthTrace trace = record_trace(
        exact_, seedling_, {.options = loop_options_named(option), .threads = threads_});
    for (ApproximateEntry& entry : entries_) {
      if (entry.option != option || !entry.engine->built()) continue;
      progress("counting wrong answers of " + entry.name());
      entry.wrong_answers =
          wrong_answer_share(trace, exact_, *entry.engine, seedling_.attraction_points, threads_);
    }
  }

  /// In an order of its own, so that no entry always follows the same one.
  void time_round(int round, int rounds) {
    CounterStream stream(0, static_cast<std::uint64_t>(round));
    for (const std::size_t i : random_order(entries_.size(), stream)) {
      ApproximateEntry& entry = entries_[i];
      if (!entry.engine->built()) continue;
      progress(fmt::format("round {} of {}: timing {}", round + 1, rounds, entry.name()));
      const GrowthResult result = grown(*entry.engine, seedling_, entry.option, threads_);
      entry.rounds.push_back(result.seconds);
      if (round + 1 < rounds) continue;
      entry.nodes = result.skeleton.node_count();
      entry.tree_difference = tree_difference(exact_tree(), result.skeleton);
    }
  }

  /// The same with any option, so grown once, when it is first needed.
  const Skeleton& exact_tree() {
    if (!exact_tree_) exact_tree_ = grown(exact_, seedling_, "s", threads_).skeleton;
    return *exact_tree_;
  }

  const Seedling& seedling_;
  const EngineDescriptor& exact_;
  int threads_;
  const std::function<void(const std::string&)>& show_progress_;
  std::optional<Skeleton> exact_tree_;
  std::vector<ApproximateEntry> entries_;
};

}  // namespace

double tree_difference(const Skeleton& exact, const Skeleton& other) {
  const std::vector<Edge> a = edges_of(exact), b = edges_of(other);
  std::vector<Edge> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const std::size_t either = a.size() + b.size() - both.size();
  return either == 0 ? 0.0
                     : static_cast<double>(either - both.size()) / static_cast<double>(either);
}

double wrong_answer_share(const GrowthTrace& trace, const EngineDescriptor& exact,
                          const EngineDescriptor& other, std::span<const Vector3> points,
                          int threads) {
  PHYTOBENCH_EXPECT(exact.built() && other.built());
  const auto right = exact.create(), asked = other.create();
  EngineSetup setup = trace.setup;
  setup.threads = threads;
  right->reset(points, setup);
  asked->reset(points, setup);
  std::uint64_t answers = 0, wrong = 0;
  for (const GrowthTrace::Step& step : trace.steps) {
    if (step.is_kill) {
      right->kill(step.nodes, step.kill_distance);
      asked->kill(step.nodes, step.kill_distance);
      continue;
    }
    const Assignment expected = right->associate(step.nodes), given = asked->associate(step.nodes);
    // Removed points have no node in either.
    for (std::size_t point = 0; point < points.size(); ++point) {
      answers += expected.node[point] != no_node || given.node[point] != no_node;
      wrong += expected.node[point] != given.node[point];
    }
  }
  return answers == 0 ? 0.0 : static_cast<double>(wrong) / static_cast<double>(answers);
}

std::vector<ApproximateEntry> run_approximate_lane(
    const Workload& workload, const EngineDescriptor& exact,
    const std::vector<std::string>& options, int rounds,
    const std::function<void(const std::string&)>& show_progress, int threads) {
  PHYTOBENCH_EXPECT(exact.built() && rounds >= 1);
  return Lane(workload, exact, threads, show_progress).run(options, rounds);
}

}  // namespace phytobench
