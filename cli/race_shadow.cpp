// SPDX-License-Identifier: MIT
#include <algorithm>

#include <nlohmann/json.hpp>

#include "benchmarks/shadow/shadow_race.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_shadow_output.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/terrain/files/height_file.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench::cli {

namespace {

/// Beyond, `all` leaves out the printed march: some seconds for every hour of a thousand squared.
constexpr std::size_t most_vertices_for_all = 512 * 512;
constexpr std::string_view slow_shadow_engine = "printed_march";

struct ChosenShadows {
  std::vector<ShadowContestant> contestants;
  std::vector<std::string> left_out;
};

const ShadowEngineDescriptor& shadow_engine_of_any_kind(const std::string& name) {
  std::vector<std::string> known{"all"};
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (engine->name == name) return *engine;
    known.emplace_back(engine->name);
  }
  throw InputError("unknown engine '" + name + "'" + did_you_mean(name, known) + "; known: all, " +
                   known_shadow_engine_names());
}

ChosenShadows chosen_shadow_engines(const ShadowRaceOptions& options, std::size_t vertices) {
  ChosenShadows chosen;
  const auto add = [&](const ShadowEngineDescriptor& engine) {
    for (const int threads : options.threads) chosen.contestants.push_back({&engine, threads});
  };
  for (const std::string& name : options.engines) {
    if (name != "all") {
      add(shadow_engine_of_any_kind(name));
      continue;
    }
    for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
      const bool is_left_out =
          engine->name == slow_shadow_engine && vertices > most_vertices_for_all;
      if (is_left_out)
        chosen.left_out.emplace_back(engine->name);
      else
        add(*engine);
    }
  }
  return chosen;
}

ShadowWorkload chosen_terrain(const ShadowRaceOptions& options) {
  if (options.terrain == "fractal")
    return fractal_shadows({.size = options.size,
                            .relief = options.relief,
                            .cell = options.cell > 0.0 ? options.cell : 16.0,
                            .hours = options.hours,
                            .seed = options.seed});
  HeightFileOptions file;
  if (options.cell > 0.0) file.cell_width = file.cell_depth = options.cell;
  return {options.terrain, read_height_file(options.terrain, file).field,
          hourly_suns(options.hours)};
}

}  // namespace

int race_shadow(const ShadowRaceOptions& options) {
  keep_freed_memory();
  const ShadowWorkload workload = chosen_terrain(options);
  const ChosenShadows chosen = chosen_shadow_engines(options, workload.field.size());
  catch_interrupts();
  const ShadowRaceResult result = race_shadows({.workload = &workload,
                                                .contestants = chosen.contestants,
                                                .budget_s = options.budget,
                                                .rounds = options.rounds,
                                                .order_seed = options.seed,
                                                .show_progress = show_progress,
                                                .is_interrupted = is_interrupted});
  const ShadowRaceReport report{&workload, &result, chosen.left_out};
  print(options.json ? json_text(shadow_race_document(report, options)) + "\n"
                     : shadow_race_table(report));
  const bool wrong = std::any_of(result.entries.begin(), result.entries.end(), [](const auto& e) {
    return e.state == ShadowEntry::State::wrong;
  });
  return wrong ? 1 : 0;
}

}  // namespace phytobench::cli
