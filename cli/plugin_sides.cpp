// SPDX-License-Identifier: MIT
#include "cli/plugin_sides.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "benchmarks/nearest_node/plugin_trial.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

std::string failed_trial(const Side& side) {
  if (side.origin.kind != "plugin") return "";
  const PluginVerdict verdict = try_plugin(side.file, {.is_interrupted = is_interrupted});
  if (verdict.is_exact()) return "";
  const std::string text =
      fmt::format("{}: {}: {}", side.origin.given, name_of(verdict.kind), verdict.detail);
  if (verdict.kind == PluginVerdict::Kind::refused) throw InputError(text);
  return text + "; nothing is timed\n";
}

std::vector<std::string> names_of(WorkerClient& client) {
  std::vector<std::string> names = client.names();
  if (client.side().origin.kind != "plugin") return names;
  Side without = client.side();
  without.worker_options.clear();
  const std::vector<std::string> known = WorkerClient(without).names();
  std::erase_if(names, [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  });
  return names;
}

}  // namespace phytobench::cli
