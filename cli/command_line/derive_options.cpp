// SPDX-License-Identifier: MIT
// Options of `derive`. Only files of this folder and main.cpp include the command-line library.
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"

namespace phytobench::cli {

void add_derive(CLI::App& app, Commands& commands) {
  LSystemDeriveOptions& options = commands.derive;
  CLI::App* sub = app.add_subcommand("derive", "Derive an L-system and draw its word");
  sub->add_option(
      "system", options.system,
      "An L-system; see --example explained. What % cuts off is not drawn; the word keeps it");
  sub->add_option("--preset", options.preset,
                  "A file that comes with the program; see phytobench list lsystems");
  sub->add_option("--steps", options.steps, "Derivations, instead of those in the file")
      ->check(CLI::Range(0, 1'000'000));
  sub->add_option("--seed", options.seed, "Of random choices, instead of that in the file")
      ->check(whole_number);
  add_files(*sub, options.out,
            "Write the drawing: .obj .glb .ply (models), .svg .png (pictures), .csv (table of "
            "segments); several comma-separated");
  sub->add_flag("--split", options.split, "Meshes of at most 65536 vertices each");
  add_camera(*sub, options);
  sub->add_option("--print", options.print,
                  "Print the word alone, so many modules of it; with --json beside the rest")
      ->check(whole_number);
  sub->add_option("--most-modules", options.most_modules,
                  "Words with more are counted, but not made")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1e11));
  sub->add_option("--threads", options.threads, "Never change the result")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option(
      "--example", options.example,
      "Print the file of this preset, to start from; or list. 'explained' explains all");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&, sub] {
    commands.chosen = unless_example_has_company(*sub, [&] { return derive(commands.derive); });
  });
}

}  // namespace phytobench::cli
