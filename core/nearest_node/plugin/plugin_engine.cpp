// SPDX-License-Identifier: MIT
#include "core/nearest_node/plugin/plugin_engine.hpp"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/nearest_node/plugin/floating_point_control.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

// Arrays are handed over as they are.
static_assert(sizeof(phytobench_vector) == sizeof(Vector3) &&
              offsetof(phytobench_vector, y) == offsetof(Vector3, y) &&
              offsetof(phytobench_vector, z) == offsetof(Vector3, z));
static_assert(sizeof(phytobench_node) == sizeof(SearchableNode) &&
              offsetof(phytobench_node, direction) == offsetof(SearchableNode, direction));

const phytobench_vector* in_c(std::span<const Vector3> points) {
  return reinterpret_cast<const phytobench_vector*>(points.data());
}

const phytobench_node* in_c(std::span<const SearchableNode> nodes) {
  return reinterpret_cast<const phytobench_node*>(nodes.data());
}

template <class Array>
std::int32_t count_of(const Array& array) {
  PHYTOBENCH_EXPECT(std::in_range<std::int32_t>(array.size()));
  return static_cast<std::int32_t>(array.size());
}

[[noreturn]] void report_changed_environment(PluginCall call, std::int32_t number) {
  throw PluginMisbehaved(described(call, number) + " changes the floating-point environment");
}

/// Calls the plugin so that others can see where it is, and lets nothing of its own out: neither
/// what it throws nor how it computes. Gives back what the body returns.
template <class Body>
auto watched(const PluginWatch& watch, PluginCall call, std::int32_t number, const Body& body) {
  const WatchedCall noted(watch, call, number);
  const FloatingPointControl before;
  decltype(body()) result{};
  try {
    result = body();
  } catch (...) {
    before.restore();
    throw PluginMisbehaved(described(call, number) + " let a C++ exception escape");
  }
  if (before.is_in_force()) return result;
  before.restore();
  report_changed_environment(call, number);
}

}  // namespace

void PluginEngine::reset(std::span<const Vector3> points, const EngineSetup& setup) {
  PHYTOBENCH_EXPECT(setup.influence_distance >= smallest_influence_distance);
  if (!destroy()) report_changed_environment(PluginCall::destroy, 0);
  points_ = points;
  threads_ = setup.threads;
  live_.resize(points.size());
  std::iota(live_.begin(), live_.end(), PointIndex{0});
  is_alive_.assign(points.size(), 1);
  written_.assign(points.size(), no_node);
  node_of_point_.assign(points.size(), no_node);
  associated_.reset(points.size());
  nodes_ = 0;
  associations_ = removals_ = 0;
  work_ = {};
  create(setup);
}

void PluginEngine::create(const EngineSetup& setup) {
  // The same expressions as in Perception, so that the plugin compares with the same bits.
  const phytobench_setup handed{
      .influence_distance = setup.influence_distance,
      .squared_reach = setup.influence_distance * setup.influence_distance,
      .perception_half_angle_rad = setup.perception_half_angle_rad,
      .cosine = std::cos(setup.perception_half_angle_rad),
      .perceives_all_around = setup.perception_half_angle_rad >= std::numbers::pi,
      .threads = setup.threads,
      .associations = setup.associations,
      .reserved = 0};
  watched(plugin_.watch(), PluginCall::create, 0, [&] {
    engine_ = table_.create(in_c(points_), count_of(points_), &handed);
    return true;  // it is destroyed even if what create() did besides is an offence
  });
  if (engine_ == nullptr) report_failure(PluginCall::create, 0);
}

bool PluginEngine::destroy() noexcept {
  if (engine_ == nullptr) return true;
  const WatchedCall noted(plugin_.watch(), PluginCall::destroy, 0);
  const FloatingPointControl before;
  table_.destroy(std::exchange(engine_, nullptr));
  const bool is_kept = before.is_in_force();
  before.restore();
  return is_kept;
}

Assignment PluginEngine::associate(std::span<const SearchableNode> new_nodes) {
  const std::int32_t status = watched(plugin_.watch(), PluginCall::associate, associations_, [&] {
    return table_.associate(engine_, in_c(new_nodes), count_of(new_nodes), written_.data());
  });
  if (status != 0) report_failure(PluginCall::associate, associations_);
  nodes_ += new_nodes.size();
  take_answers();
  work_.queries += live_.size();
  ++associations_;
  return {node_of_point_, associated_};
}

void PluginEngine::take_answers() {
  associated_.clear();
  for (const PointIndex point : live_) {
    const NodeIndex node = written_[static_cast<std::size_t>(point)];
    if (node < no_node || (node >= 0 && static_cast<std::size_t>(node) >= nodes_))
      throw PluginMisbehaved(
          fmt::format("iteration {}, point {}: node {}, which does not exist (there are {})",
                      associations_, point, node, nodes_));
    node_of_point_[static_cast<std::size_t>(point)] = node;
    if (node != no_node) associated_.insert(point);
  }
}

std::span<const PointIndex> PluginEngine::kill(std::span<const SearchableNode> killers,
                                               double kill_distance) {
  if (table_.remove != nullptr)
    let_plugin_remove(killers, kill_distance);
  else
    remove_by_grid(killers, kill_distance);
  take_out_the_dead();
  if (table_.remove == nullptr) tell_plugin();
  ++removals_;
  return removed_;
}

void PluginEngine::let_plugin_remove(std::span<const SearchableNode> killers,
                                     double kill_distance) {
  removed_.assign(live_.size(), -1);
  const std::int32_t count = watched(plugin_.watch(), PluginCall::remove, removals_, [&] {
    return table_.remove(engine_, in_c(killers), count_of(killers), kill_distance, removed_.data(),
                         count_of(live_));
  });
  if (count < 0) report_failure(PluginCall::remove, removals_);
  if (static_cast<std::size_t>(count) > live_.size())
    throw PluginMisbehaved(
        fmt::format("removal {}: {} points, but only {} are left", removals_, count, live_.size()));
  for (const PointIndex point : std::span(removed_).first(static_cast<std::size_t>(count))) {
    if (point < 0 || static_cast<std::size_t>(point) >= points_.size())
      throw PluginMisbehaved(
          fmt::format("removal {}: point {}, which does not exist", removals_, point));
    if (!std::exchange(is_alive_[static_cast<std::size_t>(point)], std::uint8_t{0}))
      throw PluginMisbehaved(
          fmt::format("removal {}: point {} twice, or removed before", removals_, point));
  }
}

void PluginEngine::remove_by_grid(std::span<const SearchableNode> killers, double kill_distance) {
  grid_.build(killers, kill_distance);
  std::atomic<std::uint64_t> evaluations{0};
  for_blocks(live_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    std::uint64_t own = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto point = static_cast<std::size_t>(live_[i]);
      if (grid_.reaches(points_[point], own)) is_alive_[point] = 0;
    }
    evaluations += own;
  });
  work_.kill_evaluations += evaluations;
}

void PluginEngine::take_out_the_dead() {
  removed_.clear();
  std::size_t kept = 0;
  for (const PointIndex point : live_) {
    const auto i = static_cast<std::size_t>(point);
    if (is_alive_[i]) {
      live_[kept++] = point;
      continue;
    }
    node_of_point_[i] = no_node;
    associated_.erase(point);
    removed_.push_back(point);
  }
  live_.resize(kept);
}

void PluginEngine::tell_plugin() {
  if (table_.removed == nullptr || removed_.empty()) return;
  watched(plugin_.watch(), PluginCall::removed, removals_, [&] {
    table_.removed(engine_, removed_.data(), count_of(removed_));
    return true;
  });
}

void PluginEngine::report_failure(PluginCall call, std::int32_t number) {
  std::string why;
  if (table_.last_error != nullptr)
    why = plain_line(watched(plugin_.watch(), PluginCall::last_error, number,
                             [&] { return table_.last_error(engine_); }));
  throw PluginMisbehaved(described(call, number) + " failed" + (why.empty() ? "" : ": " + why));
}

}  // namespace phytobench
