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

/// Follows what a plugin did in the race.
constexpr const char* restarted = "; the race was restarted without it";

/// Tells the parent that the output is a plugin's nonsense; no exit code of the work.
constexpr int misbehaved_code = 99;

const char* what_it_did(PluginVerdict::Kind kind) {
  switch (kind) {
    case PluginVerdict::Kind::hangs:
      return "hung";
    case PluginVerdict::Kind::crashed:
      return "crashed";
    default:
      return "answered wrongly";
  }
}

/// The progress line of a process that is gone still stands there.
void clear_line_of_child() {
  show_progress("");
  clear_progress();
}

SupervisedRun attempt(const SupervisionLimits& limits, const SupervisedWork& work) {
  return run_supervised(
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
}

bool is_done(const SupervisedRun& run) {
  return run.end == SupervisedRun::End::finished && run.code != misbehaved_code;
}

/// Notes the failure of the plugin that was called last.
void note_failure(const SupervisedRun& run, std::vector<TriedPlugin>& tried,
                  const SupervisionLimits& limits) {
  const PluginVerdict failure =
      run.end == SupervisedRun::End::finished
          ? PluginVerdict{.kind = PluginVerdict::Kind::wrong, .engine = {}, .detail = run.output}
          : verdict_on_unfinished(run, limits);
  const auto number = static_cast<std::size_t>(run.plugin);
  if (run.call == PluginCall::none || number >= tried.size() || !tried[number].is_raced())
    throw EnvironmentError("the race ended, though no plugin was at work: " + failure.detail);
  TriedPlugin& plugin = tried[number];
  plugin.failed_in_race = failure;
  plugin.failed_in_race->engine = plugin.verdict.engine;
  std::fprintf(stderr, "phytobench: plugin '%s' %s while it was raced: %s; %s\n",
               plugin.file.c_str(), what_it_did(failure.kind), failure.detail.c_str(),
               "the race is restarted without it");
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

const TriedPlugin* raced_plugin(const std::vector<TriedPlugin>& tried, std::string_view engine) {
  for (const TriedPlugin& plugin : tried)
    if (plugin.is_raced() && plugin.verdict.engine == engine) return &plugin;
  return nullptr;
}

bool all_raced(const std::vector<TriedPlugin>& tried) {
  return std::all_of(tried.begin(), tried.end(),
                     [](const TriedPlugin& plugin) { return plugin.is_raced(); });
}

void put_plugin(nlohmann::ordered_json& entry, const TriedPlugin& plugin) {
  entry["plugin"] = plugin.file;
  entry["trial"] = {{"verdict", name_of(plugin.verdict.kind)}, {"detail", plugin.verdict.detail}};
  if (!plugin.failed_in_race) return;
  entry["race"] = {{"verdict", name_of(plugin.failed_in_race->kind)},
                   {"detail", plugin.failed_in_race->detail + restarted}};
}

std::string failed_lines(const std::vector<TriedPlugin>& tried) {
  std::string text;
  for (const TriedPlugin& plugin : tried) {
    if (plugin.is_raced()) continue;
    const std::string name = std::filesystem::path(plugin.file).filename().string();
    text += fmt::format("{:<29} no time, {}{}: {}{}\n", name, name_of(plugin.failure().kind),
                        plugin.failed_in_race ? " in the race" : "", plugin.failure().detail,
                        plugin.failed_in_race ? restarted : "");
  }
  return text;
}

std::vector<std::unique_ptr<EnginePlugin>> load_raced(const std::vector<TriedPlugin>& tried,
                                                      PluginPulse& pulse) {
  std::vector<std::unique_ptr<EnginePlugin>> loaded;
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i].is_raced())
      loaded.push_back(std::make_unique<EnginePlugin>(
          tried[i].file, PluginWatch{.pulse = &pulse, .plugin = static_cast<std::int32_t>(i)}));
  return loaded;
}

int run_with_plugins(std::vector<TriedPlugin>& tried, const SupervisionLimits& limits,
                     const SupervisedWork& work) {
  SupervisedRun run = attempt(limits, work);
  while (!is_done(run)) {
    clear_line_of_child();
    note_failure(run, tried, limits);
    run = attempt(limits, work);
  }
  print(run.output);
  return run.code;
}

}  // namespace phytobench::cli
