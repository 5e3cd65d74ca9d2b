// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nearest_node/engine.hpp"
#include "core/nearest_node/kill_grid.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "core/nearest_node/plugin/phytobench_engine.h"

namespace phytobench {

/// One engine of a plugin. Believes nothing: every index is checked before anyone uses it, and
/// what cannot be is thrown as PluginMisbehaved, as is a change of the floating-point environment,
/// which is taken back after each call. Keeps the live points, and finds those to remove
/// for plugins that do not. Whether answers are right is not its business.
class PluginEngine final : public NearestNodeEngine {
 public:
  explicit PluginEngine(const EnginePlugin& plugin) : plugin_(plugin), table_(plugin.table()) {}
  ~PluginEngine() override { destroy(); }
  PluginEngine(const PluginEngine&) = delete;
  PluginEngine& operator=(const PluginEngine&) = delete;

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override;
  Assignment associate(std::span<const SearchableNode> new_nodes) override;
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override;

  std::size_t live_points() const override { return live_.size(); }

  /// Only what is done here: a plugin's own work is not known.
  WorkCounters counters() const override { return work_; }

 private:
  void create(const EngineSetup& setup);
  /// False if that changed the floating-point environment, which is as before again.
  bool destroy() noexcept;
  void take_answers();
  void let_plugin_remove(std::span<const SearchableNode> killers, double kill_distance);
  void remove_by_grid(std::span<const SearchableNode> killers, double kill_distance);
  void take_out_the_dead();
  void tell_plugin();
  [[noreturn]] void report_failure(PluginCall call, std::int32_t number);

  const EnginePlugin& plugin_;
  const phytobench_engine_v1& table_;
  void* engine_ = nullptr;  // the plugin's own
  std::span<const Vector3> points_;
  int threads_ = 1;
  KillGrid grid_;
  std::vector<PointIndex> live_;        // ascending
  std::vector<std::uint8_t> is_alive_;  // per point
  std::vector<NodeIndex> written_;      // per point, by the plugin
  std::vector<NodeIndex> node_of_point_;
  PointSet associated_;
  std::vector<PointIndex> removed_;
  std::size_t nodes_ = 0;
  std::int32_t associations_ = 0;
  std::int32_t removals_ = 0;
  WorkCounters work_;
};

}  // namespace phytobench
