// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"

namespace phytobench::cli {

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
  sub->add_option("--engines", options.engines,
                  "all, or names; comma-separated. On more than 512 x 512 vertices all leaves out "
                  "printed_march, which takes too long; name it to have it")
      ->delimiter(',')
      ->capture_default_str();
  sub->add_option("--threads", options.threads, "Several are raced against each other")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--budget", options.budget,
                  "Seconds for all hours once; what is predicted to take longer is skipped")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  sub->add_option("--rounds", options.rounds, "Timed rounds; 0: what fits into a minute, 3 to 25")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  sub->add_option("--seed", options.seed, "Of the fractal and the order of timing")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return race_shadow(commands.shadow_race); }; });
}

}  // namespace phytobench::cli
