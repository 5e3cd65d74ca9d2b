// SPDX-License-Identifier: MIT
// Engines from outside in `phytobench race nearest-node`: tried first, then raced in a process that
// the program outlives.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/nearest_node/plugin_trial.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench::cli {

struct TriedPlugin {
  std::string file;                                  ///< as the user named it
  PluginVerdict verdict;                             ///< of its trial
  std::optional<PluginVerdict> failed_in_race = {};  ///< although it passed its trial

  bool is_raced() const { return verdict.is_exact() && !failed_in_race; }

  /// Why it gets no time; only if it is not raced.
  const PluginVerdict& failure() const { return failed_in_race ? *failed_in_race : verdict; }
};

/// Tries each in a process of its own. Throws InputError for one that is refused, and for two that
/// call their engines alike.
std::vector<TriedPlugin> try_plugins(const std::vector<std::string>& files,
                                     const SupervisionLimits& limits);

/// "plugin nearest_scan.so: exact, every answer ...", one line each.
std::string verdict_lines(const std::vector<TriedPlugin>& tried);

/// The raced one whose engine has that name; null if there is none.
const TriedPlugin* raced_plugin(const std::vector<TriedPlugin>& tried, std::string_view engine);

bool all_raced(const std::vector<TriedPlugin>& tried);

/// Sets `plugin` and `trial` of an entry, and `race` for one that failed there.
void put_plugin(nlohmann::ordered_json& entry, const TriedPlugin& plugin);

/// A row without a time for each that failed, in its trial or in the race.
std::string failed_lines(const std::vector<TriedPlugin>& tried);

/// Those to be raced, loaded into this process.
std::vector<std::unique_ptr<EnginePlugin>> load_raced(const std::vector<TriedPlugin>& tried,
                                                      PluginPulse& pulse);

/// Does the work, which fills its output and returns an exit code, in a child process and prints
/// its output. If a plugin ends that process, hangs or answers otherwise than before, nothing of
/// that race is of use: its failure is noted in `tried`, named on standard error, and the work is
/// done once more, where load_raced() leaves that plugin out. Throws EnvironmentError if the
/// process ends although no plugin was called.
int run_with_plugins(std::vector<TriedPlugin>& tried, const SupervisionLimits& limits,
                     const SupervisedWork& work);

}  // namespace phytobench::cli
