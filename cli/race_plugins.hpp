// SPDX-License-Identifier: MIT
// Engines from outside in `phytobench race nearest-node`: tried first, then raced in a process that
// the program outlives.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/nearest_node/plugin_trial.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench::cli {

struct TriedPlugin {
  std::string file;  ///< as the user named it
  PluginVerdict verdict;
};

/// Tries each in a process of its own. Throws InputError for one that is refused, and for two that
/// call their engines alike.
std::vector<TriedPlugin> try_plugins(const std::vector<std::string>& files,
                                     const SupervisionLimits& limits);

/// "plugin nearest_scan.so: exact, every answer ...", one line each.
std::string verdict_lines(const std::vector<TriedPlugin>& tried);

/// The exact one whose engine has that name; null if there is none.
const TriedPlugin* exact_plugin(const std::vector<TriedPlugin>& tried, std::string_view engine);

bool all_exact(const std::vector<TriedPlugin>& tried);

/// Sets `plugin` and `trial` of an entry.
void put_plugin(nlohmann::ordered_json& entry, const TriedPlugin& plugin);

/// A row without a time for each that failed its trial.
std::string failed_lines(const std::vector<TriedPlugin>& tried);

/// The exact ones, loaded into this process.
std::vector<std::unique_ptr<EnginePlugin>> load_exact(const std::vector<TriedPlugin>& tried,
                                                      PluginPulse& pulse);

/// Does the work, which fills its output and returns an exit code, in a child process and prints
/// its output. A plugin that ends that process, hangs or answers nonsense is named on standard
/// error instead, with exit code 1.
int run_with_plugins(const std::vector<TriedPlugin>& tried, const SupervisionLimits& limits,
                     const SupervisedWork& work);

}  // namespace phytobench::cli
