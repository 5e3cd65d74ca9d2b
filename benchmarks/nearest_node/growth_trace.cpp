// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/growth_trace.hpp"

#include <algorithm>

#include "benchmarks/heap_memory.hpp"

namespace phytobench {

namespace {

class RecordingEngine final : public NearestNodeEngine {
 public:
  RecordingEngine(NearestNodeEngine& inner, GrowthTrace& trace) : inner_(inner), trace_(trace) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    trace_ = {.setup = setup, .steps = {}};
    inner_.reset(points, setup);
  }
  Assignment associate(std::span<const SearchableNode> nodes) override {
    trace_.steps.push_back({false, 0.0, {nodes.begin(), nodes.end()}});
    return inner_.associate(nodes);
  }
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    trace_.steps.push_back({true, distance, {killers.begin(), killers.end()}});
    return inner_.kill(killers, distance);
  }
  std::size_t live_points() const override { return inner_.live_points(); }
  WorkCounters counters() const override { return inner_.counters(); }

 private:
  NearestNodeEngine& inner_;
  GrowthTrace& trace_;
};

/// FNV-1a over whole numbers.
class Hash {
 public:
  void add(std::int64_t number) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ ^= static_cast<std::uint64_t>(number >> (8 * byte)) & 0xff;
      hash_ *= 0x100000001b3ULL;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::uint64_t hash_of(const Assignment& assignment) {
  Hash hash;
  for (const NodeIndex node : assignment.node) hash.add(node);
  return hash.value();
}

std::uint64_t hash_of(std::span<const PointIndex> removed) {
  std::vector<PointIndex> ascending(removed.begin(), removed.end());
  std::sort(ascending.begin(), ascending.end());
  Hash hash;
  for (const PointIndex point : ascending) hash.add(point);
  return hash.value();
}

/// 0 where it is not known.
double heap_in_use() {
  return static_cast<double>(heap_bytes().value_or(0));
}

}  // namespace

GrowthTrace record_trace(const EngineDescriptor& engine, const Seedling& seedling,
                         const GrowthRun& run) {
  GrowthTrace trace;
  const auto inner = engine.create();
  RecordingEngine recording(*inner, trace);
  grow_crown(seedling, recording, run);
  return trace;
}

Replay replay(const GrowthTrace& trace, const EngineDescriptor& engine,
              std::span<const Vector3> points, int threads) {
  Replay result;
  result.assignment_hashes.reserve(trace.steps.size());
  result.removal_hashes.reserve(trace.steps.size());
  const double before = heap_in_use();
  const auto instance = engine.create();
  EngineSetup setup = trace.setup;
  setup.threads = threads;
  instance->reset(points, setup);
  double most = heap_in_use();
  for (const GrowthTrace::Step& step : trace.steps) {
    if (step.is_kill)
      result.removal_hashes.push_back(hash_of(instance->kill(step.nodes, step.kill_distance)));
    else
      result.assignment_hashes.push_back(hash_of(instance->associate(step.nodes)));
    most = std::max(most, heap_in_use());
  }
  if (before > 0.0) result.bytes = most - before;
  return result;
}

}  // namespace phytobench
