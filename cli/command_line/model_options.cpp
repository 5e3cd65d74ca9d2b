// SPDX-License-Identifier: MIT
// Options of the commands that run models on a user's input. Only files of this folder and main.cpp
// include the command-line library: its header is the dearest of all.
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"

namespace phytobench::cli {

void add_camera(CLI::App& sub, CameraOptions& options) {
  sub.add_option("--azimuth", options.azimuth_deg, "Picture from this side, degrees; 0 is +x")
      ->default_str("90")
      ->check(CLI::Range(-3600.0, 3600.0));
  sub.add_option("--elevation", options.elevation_deg, "From this height, degrees above level")
      ->default_str("8")
      ->check(CLI::Range(-90.0, 90.0));
  sub.add_option("--distance", options.distance,
                 "From this far, in the plant's unit; 0: the whole plant fits")
      ->default_str("0")
      ->check(CLI::Range(0.0, 1e9));
  sub.add_option("--picture-height", options.picture_height, "Pixels")
      ->default_str("800")
      ->check(CLI::Range(16, 8192));
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
  add_files(*sub, options.out, "Write the plant as .obj, .glb or .ply; several comma-separated");
  sub->add_flag("--split", options.split, "Meshes of at most 65536 vertices each");
  sub->add_option("--picture", options.picture,
                  "Write a picture: .png of the plant, .svg of the bare skeleton")
      ->check(some_name);
  add_camera(*sub, options);
  sub->add_flag("--example", options.example, "Print a parameter file with every key explained");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&, sub] {
    commands.chosen = unless_example_has_company(*sub, [&] { return grow(commands.grow); });
  });
}

void add_overlap(CLI::App& app, Commands& commands) {
  OverlapOptions& options = commands.overlap;
  CLI::App* sub = app.add_subcommand("overlap", "Who overlaps whom, and by how much");
  sub->add_option("discs", options.discs, "CSV file with columns x, y, and r or radius")
      ->required();
  sub->add_option("--radius", options.radius,
                  "The column of radii, such as root_radius of a stand's plants.csv")
      ->default_str("r, or else radius")
      ->check(some_name);
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

void add_build(CLI::App& app, Commands& commands) {
  PlantBuildOptions& options = commands.build;
  CLI::App* sub = app.add_subcommand("build", "Build a plant from a graph of components");
  sub->add_option("graph", options.graph, "Components and links in TOML; see --example");
  sub->add_option("--preset", options.preset,
                  "A file that comes with the program; see phytobench list graphs");
  sub->add_option("--time", options.time,
                  "Of key frames; FIRST:LAST:FRAMES makes frames of an animation");
  sub->add_option("--seed", options.seed, "Of random(), instead of that in the file")
      ->check(whole_number);
  sub->add_option("--resolution", options.resolution, "Detail of meshes, 0.001 to 100")
      ->default_str("1")
      ->check(CLI::Range(0.001, 100.0));
  add_files(*sub, options.out, "Write the plant as .obj, .glb or .ply; several comma-separated");
  sub->add_flag("--split", options.split, "Meshes of at most 65536 vertices each");
  sub->add_option("--picture", options.picture, "Write a .png picture")->check(some_name);
  add_camera(*sub, options);
  sub->add_option("--threads", options.threads, "Of pictures; never change them")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_flag("--tree{list}", options.tree,
                "Print the tree of instances instead: --tree=list or --tree=dot");
  sub->add_option("--example", options.example,
                  "Print a graph that explains every key of this kind of component, or the file of "
                  "this preset; or list");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&, sub] {
    commands.chosen = unless_example_has_company(*sub, [&] { return build(commands.build); });
  });
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
  sub->callback([&, sub] {
    commands.chosen = unless_example_has_company(*sub, [&] { return compete(commands.compete); });
  });
}

}  // namespace phytobench::cli
