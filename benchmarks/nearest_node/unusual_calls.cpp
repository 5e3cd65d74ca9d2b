// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/unusual_calls.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr double reach = 0.2;  ///< of killers

std::vector<SearchableNode> some_nodes(std::uint64_t stream) {
  constexpr std::size_t count = 25;
  CounterStream numbers(17, stream);
  std::vector<SearchableNode> nodes;
  while (nodes.size() < count) {
    const double x = numbers.next_between(-1.0, 1.0);
    const double y = numbers.next_between(0.1, 2.0);
    const double z = numbers.next_between(-1.0, 1.0);
    const Vector3 position{x, y, z};
    nodes.push_back({position, position / norm(position)});
  }
  return nodes;
}

/// An engine and a trusted one that are asked the same.
class ComparedEngine {
 public:
  explicit ComparedEngine(const EngineDescriptor& engine)
      : engine_(engine.create()), trusted_(engine_named("squared_scan").create()) {}

  void start(std::vector<Vector3> points, const EngineSetup& setup) {
    engine_->reset(points, setup);
    trusted_->reset(points, setup);
    points_ = std::move(points);  // those of the start before were kept until now
    associations_ = removals_ = 0;
  }

  void add(const std::vector<SearchableNode>& nodes) {
    const Assignment answer = engine_->associate(nodes), truth = trusted_->associate(nodes);
    for (std::size_t point = 0; point < points_.size(); ++point)
      if (answer.node[point] != truth.node[point])
        throw PluginMisbehaved(fmt::format("iteration {}, point {}: node {}, but it is node {}",
                                           associations_, point, answer.node[point],
                                           truth.node[point]));
    ++associations_;
  }

  void remove(const std::vector<SearchableNode>& killers) {
    if (ascending(engine_->kill(killers, reach)) != ascending(trusted_->kill(killers, reach)))
      throw PluginMisbehaved(
          fmt::format("removal {}: other points than those within reach", removals_));
    ++removals_;
  }

 private:
  static std::vector<PointIndex> ascending(std::span<const PointIndex> points) {
    std::vector<PointIndex> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

  std::vector<Vector3> points_;  // outlive the engines
  std::unique_ptr<NearestNodeEngine> engine_;
  std::unique_ptr<NearestNodeEngine> trusted_;
  std::size_t associations_ = 0;
  std::size_t removals_ = 0;
};

void call_two_in_turns(const EngineDescriptor& engine) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), pi = std::numbers::pi;
  const EngineSetup narrow{.influence_distance = 0.6, .perception_half_angle_rad = 0.4 * pi};
  const EngineSetup wide{
      .influence_distance = infinity, .perception_half_angle_rad = pi, .threads = 2};
  ComparedEngine one(engine), other(engine);
  one.start(random_cube(300), narrow);
  other.start(random_cube(200, 0.8), wide);
  one.remove(some_nodes(1));  // before any node is there
  other.add({});
  one.add(some_nodes(1));
  other.add(some_nodes(2));
  one.add({});
  other.remove({});
  one.remove({});
  other.remove(some_nodes(3));
  one.add(some_nodes(4));
  other.add(some_nodes(3));
  one.start(random_cube(150, 0.9), wide);  // ends its first life while the other one lives
  other.add(some_nodes(5));
  one.add(some_nodes(6));
  other.remove(some_nodes(6));
  one.remove(some_nodes(7));
  other.add(some_nodes(8));
  one.add(some_nodes(9));
}

void call_one_without_points(const EngineDescriptor& engine) {
  ComparedEngine one(engine);
  one.start({}, {.influence_distance = 1.0, .perception_half_angle_rad = 1.0});
  one.add(some_nodes(1));
  one.remove(some_nodes(2));
  one.add({});
}

}  // namespace

std::string wrong_in_unusual_calls(const EngineDescriptor& engine) {
  for (const auto& [name, calls] : {std::pair{"two engines in turns", &call_two_in_turns},
                                    std::pair{"no points", &call_one_without_points}})
    try {
      calls(engine);
    } catch (const PluginMisbehaved& misbehaved) {
      return fmt::format("{}: {}", name, misbehaved.what());
    }
  return {};
}

}  // namespace phytobench
