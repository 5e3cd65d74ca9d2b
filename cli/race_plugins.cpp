// SPDX-License-Identifier: MIT
#include "cli/race_plugins.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

/// Tells the parent that the output is a plugin's nonsense; no exit code of the work.
constexpr int misbehaved_code = 99;

const char* what_it_did(const SupervisedRun& run) {
  if (run.end == SupervisedRun::End::silence) return "hung while it was raced";
  if (run.end != SupervisedRun::End::finished) return "crashed while it was raced";
  return "answered nonsense while it was raced";
}

/// The progress line of a process that is gone still stands there.
void clear_line_of_child() {
  show_progress("");
  clear_progress();
}

}  // namespace

std::vector<TriedPlugin> try_plugins(const std::vector<std::string>& files,
                                     const SupervisionLimits& limits) {
  std::vector<TriedPlugin> tried;
  for (const std::string& file : files) {
    show_progress("trying plugin " + file);
    const TriedPlugin& latest = tried.emplace_back(TriedPlugin{file, try_plugin(file, limits)});
    if (latest.verdict.kind == PluginVerdict::Kind::refused)
      throw InputError(latest.verdict.detail);
    if (latest.verdict.engine.empty()) continue;  // did not live long enough to have one
    for (const TriedPlugin& other : tried)
      if (&other != &latest && other.verdict.engine == latest.verdict.engine)
        throw InputError(fmt::format(
            "plugins '{}' and '{}' both call their engine '{}'; rename one, or race one at a time",
            other.file, file, other.verdict.engine));
  }
  return tried;
}

std::string verdict_lines(const std::vector<TriedPlugin>& tried) {
  std::string text;
  for (const TriedPlugin& plugin : tried)
    text += fmt::format("plugin {}: {}, {}\n", plugin.file, name_of(plugin.verdict.kind),
                        plugin.verdict.detail);
  return text;
}

const TriedPlugin* exact_plugin(const std::vector<TriedPlugin>& tried, std::string_view engine) {
  for (const TriedPlugin& plugin : tried)
    if (plugin.verdict.is_exact() && plugin.verdict.engine == engine) return &plugin;
  return nullptr;
}

bool all_exact(const std::vector<TriedPlugin>& tried) {
  return std::all_of(tried.begin(), tried.end(),
                     [](const TriedPlugin& plugin) { return plugin.verdict.is_exact(); });
}

void put_plugin(nlohmann::ordered_json& entry, const TriedPlugin& plugin) {
  entry["plugin"] = plugin.file;
  entry["trial"] = {{"verdict", name_of(plugin.verdict.kind)}, {"detail", plugin.verdict.detail}};
}

std::string failed_lines(const std::vector<TriedPlugin>& tried) {
  std::string text;
  for (const TriedPlugin& plugin : tried) {
    if (plugin.verdict.is_exact()) continue;
    const std::string name = std::filesystem::path(plugin.file).filename().string();
    text += fmt::format("{:<29} no time, {}: {}\n", name, name_of(plugin.verdict.kind),
                        plugin.verdict.detail);
  }
  return text;
}

std::vector<std::unique_ptr<EnginePlugin>> load_exact(const std::vector<TriedPlugin>& tried,
                                                      PluginPulse& pulse) {
  std::vector<std::unique_ptr<EnginePlugin>> loaded;
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i].verdict.is_exact())
      loaded.push_back(std::make_unique<EnginePlugin>(
          tried[i].file, PluginWatch{.pulse = &pulse, .plugin = static_cast<std::int32_t>(i)}));
  return loaded;
}

int run_with_plugins(const std::vector<TriedPlugin>& tried, const SupervisionLimits& limits,
                     const SupervisedWork& work) {
  const SupervisedRun run = run_supervised(
      [&](PluginPulse& pulse, std::string& output) {
        try {
          const int code = work(pulse, output);
          clear_progress();
          return code;
        } catch (const PluginMisbehaved& misbehaved) {
          output = misbehaved.what();
          return misbehaved_code;
        }
      },
      limits);
  if (run.end == SupervisedRun::End::finished && run.code != misbehaved_code) {
    print(run.output);
    return run.code;
  }
  clear_line_of_child();
  const std::string where =
      run.end == SupervisedRun::End::finished ? run.output : described(run, limits);
  // Without a call of a plugin it was this program's own fault.
  const std::string who =
      run.call == PluginCall::none
          ? "the race"
          : "plugin '" + tried.at(static_cast<std::size_t>(run.plugin)).file + "'";
  std::fprintf(stderr, "phytobench: %s %s: %s\n", who.c_str(), what_it_did(run), where.c_str());
  return 1;
}

}  // namespace phytobench::cli
