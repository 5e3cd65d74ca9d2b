// SPDX-License-Identifier: MIT
// Options of races. Only files of this folder and main.cpp include the command-line library: its
// header is the dearest of all.
#include <algorithm>

#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "cli/command_line/race_option_kinds.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench::cli {

namespace {

void add_nearest_node_race(CLI::App& race, Commands& commands) {
  NearestNodeRaceOptions& options = commands.nearest_node_race;
  CLI::App* sub = race.add_subcommand("nearest-node", "Engines that find nearest nodes of points");
  sub->add_option("--points", options.points, "Attraction points of the scaled test tree, about")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 2e8));
  sub->add_option("--iterations", options.iterations, "Iterations; 0: as the size asks for")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  add_names(*sub, "--engines", options.engines, "all, or names; comma-separated");
  add_names(*sub, "--options", options.options, "Loop options S, D, N, DN; comma-separated");
  add_thread_counts(*sub, options.threads,
                    "Threads of engines and growth; several are raced against each other");
  sub->add_option("--density", options.density, "Points per unit volume; 0: that of the test tree")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  add_budget(*sub, options.budget,
             "Seconds for one growth; what is predicted to take longer is skipped");
  add_rounds_or_none(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of the cloud and the order of timing");
  sub->add_option("--cloud", options.cloud, "CSV file with your own points: columns x, y, z");
  as_one_list(sub->add_option("--plugin", options.plugins,
                              "Engines from outside: shared libraries (phytobench_engine.h); "
                              "comma-separated"));
  sub->add_option("--plugin-limit", options.plugin_limit,
                  "Seconds that a single call of a plugin may take")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e6));
  add_json(*sub, options.json);
  sub->callback(
      [&] { commands.chosen = [&] { return race_nearest_node(commands.nearest_node_race); }; });
}

void add_overlap_race(CLI::App& race, Commands& commands) {
  OverlapRaceOptions& options = commands.overlap_race;
  CLI::App* sub = race.add_subcommand("overlap", "Engines that find overlapping discs");
  sub->add_option("--size", options.size, "Random discs")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 2e8));
  sub->add_option("--sizes", options.sizes,
                  "Of the discs: equal, uniform (1 to 3), mixed (1 to 1000)")
      ->capture_default_str();
  sub->add_option("--partners", options.partners, "Discs that one overlaps, on average")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e4));
  sub->add_flag("--torus", options.torus, "Join opposite sides of the ground");
  add_names(*sub, "--engines", options.engines, "all, or names; comma-separated");
  add_thread_counts(*sub, options.threads,
                    "Threads of engines that use them; several are raced against each other");
  add_budget(*sub, options.budget,
             "Seconds for one search; what is predicted to take longer is skipped");
  add_rounds_or_none(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of the discs and the order of timing");
  sub->add_option("--discs", options.discs, "CSV file with your own discs: columns x, y, r");
  sub->add_option("--window", options.window, "x0,y0,x1,y1 of the torus on which these lie");
  add_json(*sub, options.json);
  sub->callback([&] { commands.chosen = [&] { return race_overlap(commands.overlap_race); }; });
}

void add_hopkins_race(CLI::App& race, Commands& commands) {
  HopkinsRaceOptions& options = commands.hopkins_race;
  CLI::App* sub = race.add_subcommand("hopkins", "Ways to the Hopkins index: exact and sampled");
  sub->add_option("--size", options.size, "Points, about")
      ->capture_default_str()
      ->check(CLI::Range(2.0, 1e8));
  sub->add_option("--pattern", options.pattern, "random or clustered")->capture_default_str();
  sub->add_option("--threads", options.threads, "Also with so many")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  add_rounds(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of points, places and the order of timing");
  add_json(*sub, options.json);
  sub->callback([&] { commands.chosen = [&] { return race_hopkins(commands.hopkins_race); }; });
}

void add_competition_race(CLI::App& race, Commands& commands) {
  CompetitionRaceOptions& options = commands.competition_race;
  CLI::App* sub = race.add_subcommand("competition", "Rules of competition: one step of a stand");
  as_one_list_of_names(sub->add_option("--plants", options.plants,
                                       "How many; several sizes give the growth of time"))
      ->capture_default_str()
      ->check(CLI::Range(2.0, 2e7));
  sub->add_option("--pairs", options.pairs, "Overlapping pairs of root zones for each plant")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 100.0));
  add_names(*sub, "--rules", options.rules, "all, or names; comma-separated");
  add_thread_counts(*sub, options.threads, "Several are raced against each other");
  add_rounds(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of the plants and the order of timing");
  add_json(*sub, options.json);
  sub->callback(
      [&] { commands.chosen = [&] { return race_competition(commands.competition_race); }; });
}

void add_lsystem_race(CLI::App& race, Commands& commands) {
  LSystemRaceOptions& options = commands.lsystem_race;
  CLI::App* sub = race.add_subcommand("lsystem", "Engines that derive and draw L-systems");
  add_names(*sub, "--systems", options.systems,
            "all, names, or files of systems without parameters; comma-separated; published: "
            "those that others have timed, as they did with --segments 2e8");
  add_names(*sub, "--engines", options.engines, "all, or names; comma-separated");
  sub->add_option("--segments", options.segments, "Most segments of a drawing; sets derivations")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 2e9));
  sub->add_option("--modules", options.modules,
                  "Most modules of words that are only derived; 0: no such table")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  add_thread_counts(*sub, options.threads,
                    "Threads of engines that use them; several are raced against each other");
  add_rounds(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of the order of timing");
  add_json(*sub, options.json);
  sub->callback([&] { commands.chosen = [&] { return race_lsystem(commands.lsystem_race); }; });
}

void add_shadow_race(CLI::App& race, Commands& commands) {
  ShadowRaceOptions& options = commands.shadow_race;
  CLI::App* sub = race.add_subcommand("shadow", "Engines that find what the sun reaches");
  sub->add_option("--size", options.size, "Vertices a side of a fractal")
      ->capture_default_str()
      ->check(CLI::Range(2, 16384));
  sub->add_option("--hours", options.hours, "Of the thesis' day, from horizon over zenith")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  sub->add_option("--relief", options.relief, "m from the lowest to the highest of a fractal")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  sub->add_option("--cell", options.cell, "m between vertices; 0: 16, or what a file says")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  sub->add_option("--terrain", options.terrain, "fractal, or a file of heights")
      ->capture_default_str();
  add_names(*sub, "--engines", options.engines,
            "all, or names; comma-separated. On more than 512 x 512 vertices all leaves out "
            "printed_march, which takes too long; name it to have it");
  add_thread_counts(*sub, options.threads, "Several are raced against each other");
  add_budget(*sub, options.budget,
             "Seconds for all hours once; what is predicted to take longer is skipped");
  add_rounds_or_none(*sub, options.rounds);
  add_seed(*sub, options.seed, "Of the fractal and the order of timing");
  add_json(*sub, options.json);
  sub->callback([&] { commands.chosen = [&] { return race_shadow(commands.shadow_race); }; });
}

}  // namespace

void add_race(CLI::App& app, Commands& commands) {
  CLI::App* sub = app.add_subcommand("race", "Prove engines exact, then time them in turns");
  sub->require_subcommand(1);
  add_nearest_node_race(*sub, commands);
  add_overlap_race(*sub, commands);
  add_hopkins_race(*sub, commands);
  add_competition_race(*sub, commands);
  add_lsystem_race(*sub, commands);
  add_shadow_race(*sub, commands);
}

void refuse_unknown_race(int argc, char** argv) {
  const std::vector<std::string> names = {"nearest-node", "overlap", "hopkins",
                                          "competition",  "lsystem", "shadow"};
  if (argc < 2 || std::string(argv[1]) != "race") return;
  const std::string what = argc < 3 ? "" : argv[2];
  if (what == "--help" || what == "-h" ||
      std::find(names.begin(), names.end(), what) != names.end())
    return;
  throw InputError(
      "cannot race '" + what + "'" + did_you_mean(what, names) +
      "; use phytobench race nearest-node, race overlap, race hopkins, race competition, "
      "race lsystem or race shadow");
}

}  // namespace phytobench::cli
