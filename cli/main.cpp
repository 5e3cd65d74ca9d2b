// SPDX-License-Identifier: MIT
// Reads the command line and turns whatever happens into one line and an exit code. The only file
// that includes the command-line library.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "build_information.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench::cli {

namespace {

enum ExitCode {
  ok = 0,
  difference = 1,
  bad_input = 2,
  environment = 3,
  nothing_selected = 4,
  interrupted = 130
};

/// Standard options of a subcommand and what it runs.
struct Commands {
  ListOptions list;
  RunOptions run;
  ReportOptions report;
  GrowOptions grow;
  NearestNodeRaceOptions nearest_node_race;
  OverlapRaceOptions overlap_race;
  HopkinsRaceOptions hopkins_race;
  CompetitionRaceOptions competition_race;
  OverlapOptions overlap;
  PatternOptions pattern;
  CompeteOptions compete;
  DoctorOptions doctor;
  std::function<int()> chosen = {};
};

/// The library reads "-1" as a huge unsigned number and accepts digits without end.
std::string whole_number(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits && text.size() <= 18 ? "" : "give a whole number of at most 18 digits";
}

void add_list(CLI::App& app, Commands& commands) {
  CLI::App* sub =
      app.add_subcommand("list", "What there is: papers, claims, experiments, engines, rules");
  sub->add_option(
      "what", commands.list.what,
      "papers, claims, experiments, engines, overlap-engines, presets, stands or rules; "
      "all counted without it");
  sub->add_flag("--json", commands.list.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return list(commands.list); }; });
}

void add_run(CLI::App& app, Commands& commands) {
  RunOptions& options = commands.run;
  CLI::App* sub = app.add_subcommand("run", "Run experiments and keep what they measure");
  sub->add_option("experiments", options.experiments, "Ids or globs; all without it");
  sub->add_option("--tier", options.tier, "smoke (seconds), quick (minutes) or full")
      ->capture_default_str();
  sub->add_option("--seed", options.seed, "Start of the suite's own random numbers")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--threads", options.threads, "Threads of the engines")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--out", options.out, "Folder for records and artifacts")->capture_default_str();
  sub->add_flag("--resume", options.resume, "Go on with the run in that folder");
  sub->add_flag("--dry-run", options.dry_run, "Only say what would run, and for how long");
  sub->callback([&] { commands.chosen = [&] { return run(commands.run); }; });
}

void add_report(CLI::App& app, Commands& commands) {
  ReportOptions& options = commands.report;
  CLI::App* sub = app.add_subcommand("report", "Judge the records of runs and write the report");
  sub->add_option("folder", options.folders,
                  "Folder of a run; several, of other machines or compilers, are merged")
      ->required();
  sub->add_option("--out", options.out,
                  "Folder for the report, in place of an earlier one there (default: "
                  "<folder>/report; needed for several runs)");
  sub->add_option("--format", options.formats, "html, md, latex, csv, junit; comma-separated")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  sub->add_flag("--without-varying", options.without_varying,
                "Leave out what differs between equal runs: times, machine");
  sub->add_flag("--strict", options.strict, "Exit with 5 if a verdict is inconclusive");
  sub->callback([&] { commands.chosen = [&] { return report(commands.report); }; });
}

void add_grow(CLI::App& app, Commands& commands) {
  GrowOptions& options = commands.grow;
  CLI::App* sub = app.add_subcommand("grow", "Grow a tree from a parameter file");
  sub->add_option("config", options.config, "Parameters in TOML; see --example");
  sub->add_option("--engine", options.engine, "Nearest-node engine; see phytobench list engines")
      ->capture_default_str();
  sub->add_option("--option", options.option, "Loop option s, d, n or dn; never changes the tree")
      ->capture_default_str();
  sub->add_option("--threads", options.threads, "Threads of the engine")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--preset", options.preset,
                  "A parameter file that comes with the program; see phytobench list presets");
  sub->add_option("--out", options.out, "Write the plant as .obj, .glb or both; comma-separated")
      ->delimiter(',');
  sub->add_flag("--split", options.split, "Meshes of at most 65536 vertices each");
  sub->add_option("--picture", options.picture,
                  "Write a picture: .png of the plant, .svg of the bare skeleton");
  sub->add_option("--azimuth", options.azimuth_deg, "Picture from this side, degrees; 0 is +x")
      ->capture_default_str()
      ->check(CLI::Range(-3600.0, 3600.0));
  sub->add_option("--elevation", options.elevation_deg, "From this height, degrees above level")
      ->capture_default_str()
      ->check(CLI::Range(-90.0, 90.0));
  sub->add_option("--distance", options.distance,
                  "From this far, in the plant's unit; 0: the whole plant fits")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  sub->add_option("--picture-height", options.picture_height, "Pixels")
      ->capture_default_str()
      ->check(CLI::Range(16, 8192));
  sub->add_flag("--example", options.example, "Print a parameter file with every key explained");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return grow(commands.grow); }; });
}

void add_nearest_node_race(CLI::App& race, Commands& commands) {
  NearestNodeRaceOptions& options = commands.nearest_node_race;
  CLI::App* sub = race.add_subcommand("nearest-node", "Engines that find nearest nodes of points");
  sub->add_option("--points", options.points, "Attraction points of the scaled test tree, about")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 2e8));
  sub->add_option("--iterations", options.iterations, "Iterations; 0: as the size asks for")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  sub->add_option("--engines", options.engines, "all, or names; comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  sub->add_option("--options", options.options, "Loop options S, D, N, DN; comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  sub->add_option("--threads", options.threads,
                  "Threads of engines and growth; several are raced against each other")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--density", options.density, "Points per unit volume; 0: that of the test tree")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  sub->add_option("--budget", options.budget,
                  "Seconds for one growth; what is predicted to take longer is skipped")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  sub->add_option("--rounds", options.rounds, "Timed rounds; 0: what fits into a minute, 3 to 25")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  sub->add_option("--seed", options.seed, "Of the cloud and the order of timing")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--cloud", options.cloud, "CSV file with your own points: columns x, y, z");
  sub->add_flag("--json", options.json, "One JSON document");
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
  sub->add_option("--engines", options.engines, "all, or names; comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  sub->add_option("--threads", options.threads,
                  "Threads of engines that use them; several are raced against each other")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--budget", options.budget,
                  "Seconds for one search; what is predicted to take longer is skipped")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  sub->add_option("--rounds", options.rounds, "Timed rounds; 0: what fits into a minute, 3 to 25")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  sub->add_option("--seed", options.seed, "Of the discs and the order of timing")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--discs", options.discs, "CSV file with your own discs: columns x, y, r");
  sub->add_option("--window", options.window, "x0,y0,x1,y1 of the torus on which these lie");
  sub->add_flag("--json", options.json, "One JSON document");
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
  sub->add_option("--rounds", options.rounds, "Timed rounds")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  sub->add_option("--seed", options.seed, "Of points, places and the order of timing")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return race_hopkins(commands.hopkins_race); }; });
}

void add_competition_race(CLI::App& race, Commands& commands) {
  CompetitionRaceOptions& options = commands.competition_race;
  CLI::App* sub = race.add_subcommand("competition", "Rules of competition: one step of a stand");
  sub->add_option("--plants", options.plants, "How many; several sizes give the growth of time")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(2.0, 2e7));
  sub->add_option("--pairs", options.pairs, "Overlapping pairs of root zones for each plant")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 100.0));
  sub->add_option("--rules", options.rules, "all, or names; comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  sub->add_option("--threads", options.threads, "Several are raced against each other")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--rounds", options.rounds, "Timed rounds")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  sub->add_option("--seed", options.seed, "Of the plants and the order of timing")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback(
      [&] { commands.chosen = [&] { return race_competition(commands.competition_race); }; });
}

void add_race(CLI::App& app, Commands& commands) {
  CLI::App* sub = app.add_subcommand("race", "Prove engines exact, then time them in turns");
  sub->require_subcommand(1);
  add_nearest_node_race(*sub, commands);
  add_overlap_race(*sub, commands);
  add_hopkins_race(*sub, commands);
  add_competition_race(*sub, commands);
}

void add_overlap(CLI::App& app, Commands& commands) {
  OverlapOptions& options = commands.overlap;
  CLI::App* sub = app.add_subcommand("overlap", "Who overlaps whom, and by how much");
  sub->add_option("discs", options.discs, "CSV file with columns x, y, r")->required();
  sub->add_option("--radius", options.radius,
                  "The column of radii, such as root_radius of a stand's plants.csv")
      ->capture_default_str();
  sub->add_option("--window", options.window,
                  "x0,y0,x1,y1: count covered ground inside it, bare ground too");
  sub->add_flag("--torus", options.torus, "Join opposite sides of the window");
  sub->add_option("--engine", options.engine, "Overlap engine; see phytobench list overlap-engines")
      ->capture_default_str();
  sub->add_option("--threads", options.threads, "Never change the result")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--most-pairs", options.most_pairs, "Give up beyond so many; 16 bytes each")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1e11));
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return overlap(commands.overlap); }; });
}

void add_pattern(CLI::App& app, Commands& commands) {
  PatternOptions& options = commands.pattern;
  CLI::App* sub = app.add_subcommand("pattern", "Random, clustered or regular: what a pattern is");
  sub->add_option("points", options.points, "CSV file with columns x, y")->required();
  sub->add_option("--window", options.window,
                  "x0,y0,x1,y1: where all points were recorded; else their bounding box");
  sub->add_option("--polygon", options.polygon, "The same as a CSV file of corners: columns x, y");
  sub->add_flag("--torus", options.torus, "Join opposite sides of the window");
  sub->add_option("--mark", options.mark, "Column of sizes: do neighbours keep each other small?");
  sub->add_option("--species", options.species, "Column of names: which keep together or apart?");
  sub->add_option("--simulations", options.simulations, "Random patterns to compare with")
      ->capture_default_str()
      ->check(CLI::Range(39, 100000));
  sub->add_option("--seed", options.seed, "Of these, and of sampled places")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--threads", options.threads, "Never change the result")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return pattern(commands.pattern); }; });
}

void add_compete(CLI::App& app, Commands& commands) {
  CompeteOptions& options = commands.compete;
  constexpr std::int32_t most_steps = 1'000'000'000;
  CLI::App* sub =
      app.add_subcommand("compete", "A population of plants that compete, step by step");
  sub->add_option("config", options.config, "Parameters in TOML; see --example");
  sub->add_option("--preset", options.preset,
                  "A parameter file that comes with the program; see phytobench list stands");
  sub->add_option("--plants", options.plants,
                  "CSV file of plants to start with: columns x, y, radius, species");
  sub->add_option("--out", options.out, "Folder for tables, pictures and checkpoints");
  sub->add_option("--steps", options.steps, "Instead of those in the parameter file")
      ->check(CLI::Range(0, 1'000'000));
  sub->add_option("--seed", options.seed, "The same")->check(whole_number);
  sub->add_option("--rule", options.rule, "The same; see phytobench list rules");
  sub->add_option("--engine", options.engine, "Overlap engine; see phytobench list overlap-engines")
      ->capture_default_str();
  sub->add_option("--threads", options.threads, "Never change the result")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--every", options.every, "Steps between lines of steps.csv (default: 1)")
      ->check(CLI::Range(1, most_steps));
  sub->add_option("--frames", options.frames, "Steps between pictures in frames/ (default: none)")
      ->check(CLI::Range(1, most_steps));
  sub->add_option("--frame-format", options.frame_format, "png, or svg for up to 20000 plants")
      ->capture_default_str();
  sub->add_flag("--statistics", options.statistics,
                "Of the pattern, even of more than 20000 plants");
  sub->add_option("--checkpoint", options.checkpoint,
                  "Steps between checkpoints (default: 100); keeps the last one, to go on from")
      ->check(CLI::Range(1, most_steps));
  sub->add_flag("--resume", options.resume, "Go on with the run in --out");
  sub->add_flag("--example", options.example, "Print a parameter file with every key explained");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return compete(commands.compete); }; });
}

void add_doctor(CLI::App& app, Commands& commands) {
  CLI::App* sub =
      app.add_subcommand("doctor", "What is installed, what is missing, is this machine quiet");
  sub->add_flag("--json", commands.doctor.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return doctor(commands.doctor); }; });
}

std::string joined(int argc, char** argv) {
  std::string text = "phytobench";
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

/// The library would only say that some subcommand is required.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  const std::string known =
      fmt::format("; commands: {} (phytobench --help)", fmt::join(names, ", "));
  if (argc < 2) throw InputError("no command given" + known);
  const std::string first = argv[1];
  const std::vector<std::string> options = {"--help", "-h", "--version"};
  if (first.starts_with("-") && std::find(options.begin(), options.end(), first) == options.end())
    throw InputError("unknown option '" + first + "'" + known);
  if (first.starts_with("-") || std::find(names.begin(), names.end(), first) != names.end()) return;
  throw InputError("unknown command '" + first + "'" + did_you_mean(first, names) + known);
}

void refuse_unknown_race(int argc, char** argv) {
  const std::vector<std::string> names = {"nearest-node", "overlap", "hopkins", "competition"};
  if (argc < 2 || std::string(argv[1]) != "race") return;
  const std::string what = argc < 3 ? "" : argv[2];
  if (what == "--help" || what == "-h" ||
      std::find(names.begin(), names.end(), what) != names.end())
    return;
  throw InputError(
      "cannot race '" + what + "'" + did_you_mean(what, names) +
      "; use phytobench race nearest-node, race overlap, race hopkins or race competition");
}

/// Help of the subcommand that was asked for it, or of the program.
std::string help_of(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app.help() : help_of(*chosen.front());
}

int run_command_line(int argc, char** argv) {
  CLI::App app("phytobench: validation and benchmarks for computational plant models",
               "phytobench");
  app.set_version_flag("--version", fmt::format("phytobench {} ({})", build_information::version,
                                                build_information::commit));
  app.require_subcommand(1);
  Commands commands;
  commands.run.command_line = commands.nearest_node_race.command_line =
      commands.overlap_race.command_line = commands.hopkins_race.command_line =
          commands.competition_race.command_line = joined(argc, argv);
  add_list(app, commands);
  add_run(app, commands);
  add_report(app, commands);
  add_grow(app, commands);
  add_race(app, commands);
  add_overlap(app, commands);
  add_pattern(app, commands);
  add_compete(app, commands);
  add_doctor(app, commands);
  refuse_unknown_command(app, argc, argv);
  refuse_unknown_race(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
      print(version ? std::string(error.what()) + "\n" : help_of(app));
      return ok;
    }
    throw InputError(std::string(error.what()) + " (phytobench --help)");
  }
  return commands.chosen();
}

int fail(ExitCode code, const std::exception& error) {
  clear_progress();
  std::string line = error.what();
  for (char& c : line)  // what the user typed may stand in it
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  std::fprintf(stderr, "phytobench: %s\n", line.c_str());
  return code;
}

}  // namespace

}  // namespace phytobench::cli

int main(int argc, char** argv) {
  using namespace phytobench;
  using namespace phytobench::cli;
  try {
    const int code = run_command_line(argc, argv);
    clear_progress();
    return code;
  } catch (const InputError& error) {
    return fail(bad_input, error);
  } catch (const NothingSelected& error) {
    return fail(nothing_selected, error);
  } catch (const Interrupted& error) {
    return fail(interrupted, error);
  } catch (const std::bad_alloc&) {
    return fail(environment,
                EnvironmentError("out of memory; ask for fewer points or plants, or free some"));
  } catch (const std::exception& error) {
    return fail(environment, error);
  }
}
