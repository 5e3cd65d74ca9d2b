// SPDX-License-Identifier: MIT
#include "cli/plugin_sides.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "benchmarks/nearest_node/plugin_trial.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

std::optional<FailedTrial> trial_of(const Side& side, const std::string& role,
                                    double call_limit_s) {
  if (side.origin.kind != "plugin") return std::nullopt;
  const PluginVerdict verdict =
      try_plugin(side.file, {.silence_s = call_limit_s, .is_interrupted = is_interrupted});
  if (verdict.is_exact()) return std::nullopt;
  if (verdict.kind == PluginVerdict::Kind::refused)
    throw InputError(
        fmt::format("{}: {}: {}", side.origin.given, name_of(verdict.kind), verdict.detail));
  return FailedTrial{.side = role,
                     .given = side.origin.given,
                     .verdict = std::string(name_of(verdict.kind)),
                     .detail = verdict.detail};
}

std::string failed_trial(const Side& side) {
  const std::optional<FailedTrial> failed = trial_of(side, "");
  return failed ? fmt::format("{}: {}: {}; nothing is timed\n", failed->given, failed->verdict,
                              failed->detail)
                : "";
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
