// SPDX-License-Identifier: MIT
// Options of `terrain`. Only files of this folder and main.cpp include the command-line library.
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "cli/command_line/list_options.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

/// What the command maps, and how.
void add_site(CLI::App& sub, TerrainOptions& options) {
  sub.add_option("site", options.site, "A site in TOML; see --example");
  sub.add_option("--preset", options.preset,
                 "A site that comes with the program; see phytobench list sites")
      ->check(some_name);
  as_one_list_of_names(
      sub.add_option("--species", options.species,
                     "Species to map instead of those in the file; comma-separated"));
  sub.add_option("--as-printed", options.as_printed,
                 "Errata of [Lesser2019] to leave as they are printed: ids such as E16,E13, or "
                 "all, which are those of the program's listings; see phytobench list errata")
      ->check(some_value);
  sub.add_option("--engine", options.engine,
                 "Of shadows, instead of that in the file; see phytobench list shadow-engines")
      ->check(some_name);
  sub.add_option("--threads", options.threads, "Never change the result")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
}

}  // namespace

void add_terrain(CLI::App& app, Commands& commands) {
  TerrainOptions& options = commands.terrain;
  CLI::App* sub = app.add_subcommand("terrain", "Where on a terrain can which plants grow?");
  add_site(*sub, options);
  sub->add_option("--out", options.out, "Folder for maps, plants and a summary")->check(some_name);
  const CLI::Option* maps =
      as_one_list_of_names(
          sub->add_option("--maps", options.maps,
                          "Formats of maps in --out: png, svg (with legend), tif, asc, csv; "
                          "comma-separated, or none"))
          ->capture_default_str();
  sub->add_option("--plants", options.plants,
                  "Place plants by their chance, for compete: how many, or as in 200/ha so many "
                  "where the chance is 1")
      ->check(some_value);
  sub->add_option("--seed", options.seed, "Of plants")->capture_default_str()->check(whole_number);
  sub->add_flag("--example", options.example, "Print a site with every key explained");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&commands, maps, sub] {
    if (maps->count() > 0 && commands.terrain.out.empty())
      throw InputError("--maps needs --out DIR, the folder for the maps");
    commands.chosen =
        unless_example_has_company(*sub, [&commands] { return terrain(commands.terrain); });
  });
}

}  // namespace phytobench::cli
