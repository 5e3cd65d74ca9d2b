// SPDX-License-Identifier: MIT
// One function per subcommand, each in a file of its own. Options are plain structs: only main.cpp
// and command_line/ know the command-line library.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace phytobench::cli {

struct ListOptions {
  std::string what;  ///< papers, claims, experiments, engines, rules; empty: an overview
  bool json = false;
};
int list(const ListOptions& options);

struct RunOptions {
  std::vector<std::string> experiments;
  std::string tier = "quick";
  std::uint64_t seed = 0;
  int threads = 1;
  std::string out = "results";
  bool resume = false;
  bool dry_run = false;
  std::string command_line;
};
int run(const RunOptions& options);

struct ReportOptions {
  std::vector<std::string> folders;  ///< of runs; several are merged
  std::string out;                   ///< empty: <folder>/report, of one run only
  std::vector<std::string> formats{"html", "md", "latex", "csv", "junit"};
  bool without_varying = false;
  bool strict = false;
};
int report(const ReportOptions& options);

/// From where the picture of a plant is taken. Unset: as PlantView has it.
struct CameraOptions {
  std::optional<double> azimuth_deg = {};
  std::optional<double> elevation_deg = {};
  std::optional<double> distance = {};  ///< 0: the whole plant fits
  std::optional<int> picture_height = {};
};

struct GrowOptions : CameraOptions {
  std::string config;
  std::string preset;  ///< instead of a file
  std::string engine = "node_driven";
  std::string option = "dn";
  int threads = 1;
  std::vector<std::string> out;  ///< .obj or .glb files
  bool split = false;            ///< meshes of at most 65,536 vertices
  std::string picture;           ///< .png of the plant or .svg of the skeleton; empty: none
  bool example = false;
  bool json = false;
};
int grow(const GrowOptions& options);

struct NearestNodeRaceOptions {
  double points = 25298;
  int iterations = 0;  ///< 0: as many as the size asks for
  std::vector<std::string> engines{"all"};
  std::vector<std::string> options{"s", "d", "n", "dn"};
  std::vector<int> threads{1};
  double density = 0.0;  ///< 0: that of the thesis' test tree
  double budget = 120.0;
  int rounds = 0;  ///< 0: as many as fit into a minute, at least 3
  std::uint64_t seed = 0;
  std::string cloud;                 ///< CSV file; empty: the scaled test tree
  std::vector<std::string> plugins;  ///< shared libraries (phytobench_engine.h)
  double plugin_limit = 30.0;        ///< seconds that one call of a plugin may take
  bool json = false;
  std::string command_line;
};
int race_nearest_node(const NearestNodeRaceOptions& options);

struct OverlapRaceOptions {
  double size = 1e6;  ///< discs
  std::string sizes = "equal";
  double partners = 10.4;  ///< of a disc, on average
  bool torus = false;
  std::vector<std::string> engines{"all"};
  std::vector<int> threads{1};
  double budget = 120.0;
  int rounds = 0;  ///< 0: as many as fit into a minute, at least 3
  std::uint64_t seed = 0;
  std::string discs;   ///< CSV file instead of random discs
  std::string window;  ///< x0,y0,x1,y1 of a torus of these
  bool json = false;
  std::string command_line;
};
int race_overlap(const OverlapRaceOptions& options);

struct HopkinsRaceOptions {
  double size = 1e6;  ///< points
  std::string pattern = "random";
  int threads = 1;
  int rounds = 7;
  std::uint64_t seed = 0;
  bool json = false;
  std::string command_line;
};
int race_hopkins(const HopkinsRaceOptions& options);

struct CompetitionRaceOptions {
  std::vector<double> plants{1e5};
  double pairs = 5.0;  ///< of root zones, for each plant
  std::vector<std::string> rules{"all"};
  std::vector<int> threads{1};
  int rounds = 7;
  std::uint64_t seed = 0;
  bool json = false;
  std::string command_line;
};
int race_competition(const CompetitionRaceOptions& options);

struct LSystemRaceOptions {
  std::vector<std::string> systems{"all"};  ///< names, or files
  std::vector<std::string> engines{"all"};
  std::vector<int> threads{1};
  double segments = 1e7;  ///< of a drawing, at most
  double modules = 2e7;   ///< of a word that is only derived, at most; 0: none is
  int rounds = 7;
  std::uint64_t seed = 0;
  bool json = false;
  std::string command_line;
};
int race_lsystem(const LSystemRaceOptions& options);

struct ShadowRaceOptions {
  int size = 1024;  ///< vertices a side of a fractal
  int hours = 13;
  double relief = 2000.0;           ///< m, of a fractal
  double cell = 0.0;                ///< m; 0: 16 of a fractal, what a file says
  std::string terrain = "fractal";  ///< or a file of heights
  std::vector<std::string> engines{"all"};
  std::vector<int> threads{1};
  double budget = 120.0;
  int rounds = 0;  ///< 0: as many as fit into a minute, at least 3
  std::uint64_t seed = 0;
  bool json = false;
  std::string command_line;
};
int race_shadow(const ShadowRaceOptions& options);

struct PlantBuildOptions : CameraOptions {
  std::string graph;                  ///< file of components
  std::string preset;                 ///< instead of a file
  std::string time;                   ///< "T" or "FIRST:LAST:FRAMES"; empty: as the file says
  std::optional<std::uint64_t> seed;  ///< unset: as the file says
  std::optional<double> resolution;   ///< detail of meshes; unset: 1
  std::vector<std::string> out;       ///< .obj or .glb files
  bool split = false;                 ///< meshes of at most 65,536 vertices
  std::string picture;                ///< .png; empty: none
  int threads = 1;                    ///< of pictures
  std::string tree;                   ///< list or dot: prints the i-tree instead; empty: no
  std::string example;                ///< kind of component to explain, preset or list
  bool json = false;
};
int build(const PlantBuildOptions& options);

struct LSystemDeriveOptions : CameraOptions {
  std::string system;                  ///< file of an L-system
  std::string preset;                  ///< instead of a file
  std::optional<std::int32_t> steps;   ///< unset: as the file says
  std::optional<std::uint64_t> seed;   ///< the same
  std::vector<std::string> out;        ///< .obj, .glb, .ply, .svg, .png or .csv files
  bool split = false;                  ///< meshes of at most 65,536 vertices
  std::optional<std::uint64_t> print;  ///< modules of the word to show; unset: none
  double most_modules = 1e8;           ///< longer words are counted, but not made
  int threads = 1;
  std::string example;  ///< preset to print, or list; empty: none
  bool json = false;
};
int derive(const LSystemDeriveOptions& options);

struct OverlapOptions {
  std::string discs;   ///< CSV file
  std::string radius;  ///< its column of radii; empty: "r", or else "radius"
  std::string window;  ///< x0,y0,x1,y1; empty: the open plane
  bool torus = false;
  std::string engine = "layered_grid";
  int threads = 1;
  double most_pairs = 1e8;
  bool json = false;
};
int overlap(const OverlapOptions& options);

struct PatternOptions {
  std::string points;   ///< CSV file
  std::string window;   ///< x0,y0,x1,y1
  std::string polygon;  ///< CSV file of corners; neither: the bounding box
  bool torus = false;
  std::string mark;     ///< column of numbers, for the mark correlation
  std::string species;  ///< column of words, for cross-type statistics
  int simulations = 999;
  std::uint64_t seed = 0;
  int threads = 1;
  bool json = false;
};
int pattern(const PatternOptions& options);

struct CompeteOptions {
  std::string config;
  std::string preset;  ///< instead of a file
  std::string plants;  ///< CSV file; empty: the one that the parameter file names, if any
  std::string out;     ///< folder; empty: nothing is written
  std::optional<std::int32_t> steps;  ///< unset: as the parameter file says
  std::optional<std::uint64_t> seed;  ///< the same
  std::string rule;                   ///< empty: the same
  std::string engine = "layered_grid";
  int threads = 1;
  std::optional<std::int32_t> every;       ///< steps between lines of steps.csv; unset: 1
  std::int32_t frames = 0;                 ///< steps between pictures; 0: none
  std::string frame_format = "png";        ///< or svg
  bool statistics = false;                 ///< of the pattern, however many plants there are
  std::optional<std::int32_t> checkpoint;  ///< steps; unset: 100, and none is left at the end
  bool resume = false;
  bool example = false;
  bool json = false;
};
int compete(const CompeteOptions& options);

struct BenchListOptions {
  std::vector<std::string> benchmarks;  ///< names or globs; empty: all
  bool json = false;
};
int bench_list(const BenchListOptions& options);

struct BenchCountersOptions {
  std::vector<std::string> benchmarks;  ///< names or globs; empty: all
  std::string baseline;  ///< file; empty: benchmarks/baselines/counters.json of the sources
  std::string worker;    ///< program or its folder; empty: the one that counts is looked for
  bool accept = false;   ///< writes the file instead of failing
  std::string out;       ///< JSON file with what was counted and its build; empty: none
  std::string junit;     ///< file; empty: none
  bool json = false;
};
int bench_counters(const BenchCountersOptions& options);

struct BenchInstructionsOptions {
  std::vector<std::string> benchmarks;  ///< names or globs; empty: all
  std::string base;       ///< revision or build folder; empty: the commit before the new build
  std::string new_build;  ///< the same; empty: the folder of this program
  bool own_only = false;  ///< leaves out what is mostly another library's work
  int threads = 0;        ///< processes at a time; 0: as many as processors
  bool simulate_cache = false;
  bool allow_no_base = false;  ///< nothing to compare with is a pass
  std::string accepted;  ///< TOML file; empty: benchmarks/baselines/accepted_instructions.toml
  std::string history;   ///< SQLite file with earlier counts; empty: none
  std::string junit;     ///< file; empty: none
  std::string markdown;  ///< file; empty: none
  bool json = false;
};
int bench_instructions(const BenchInstructionsOptions& options);

struct BenchMeasureOptions {
  std::vector<std::string> benchmarks;  ///< names or globs; empty: all
  std::string side;    ///< revision, build folder or plugin; empty: the build of this program
  int processes = 12;  ///< one repetition each
  int samples = 5;     ///< of each benchmark in each process
  double sample_ms = 10.0;
  std::uint64_t seed = 0;
  std::string out;  ///< JSON file; empty: none
  bool json = false;
};
int bench_measure(const BenchMeasureOptions& options);

struct CompareOptions {
  std::string base;   ///< revision, build folder, plugin (.so) or stored result (.json)
  std::string other;  ///< the same
  std::vector<std::string> benchmarks;      ///< names or globs; empty: all
  std::optional<double> tolerance_percent;  ///< unset: 3, and 10 with a stored result
  double budget_s = 300.0;                  ///< of the timing
  int least_blocks = 8;                     ///< more where so many benchmarks need it
  int most_blocks = 60;                     ///< at least as many as the least
  int samples = 5;                          ///< of each benchmark in each process
  double sample_ms = 10.0;
  std::uint64_t seed = 0;
  std::string out;             ///< JSON file; empty: none
  std::string markdown;        ///< file; empty: none
  std::string junit;           ///< file; empty: none
  std::string cache;           ///< folder for builds of revisions; empty: build/compare
  double plugin_limit = 30.0;  ///< seconds that a call of a plugin may take in its trial, and an
                               ///< answer where it is timed
  bool time_anyway = false;    ///< even if both programs are the same
  bool strict = false;
  bool json = false;
  std::string command_line;
};
int compare(const CompareOptions& options);

struct SelftestOptions {
  int repetitions = 40;  ///< of equal sides; a quarter as many, rounded up, with a known loss
  std::uint64_t seed = 0;
  bool strict = false;
  bool json = false;
  std::string command_line;
};
int selftest(const SelftestOptions& options);

struct HistoryOptions {
  std::string action = "list";     ///< list, show, plot, append, save, compare
  std::vector<std::string> names;  ///< a benchmark, files, or names of baselines
  std::string quantity;            ///< counter:NAME, instructions, ratio; empty: all there are
  std::string file = "build/history.sqlite";
  std::string out;  ///< .svg of a plot; empty: none
  bool json = false;
  std::string command_line;
};
int history(const HistoryOptions& options);

struct TerrainOptions {
  std::string site;
  std::string preset;                           ///< instead of a file
  std::vector<std::string> species;             ///< empty: as the site file says
  std::string out;                              ///< folder; empty: nothing is written
  std::vector<std::string> maps{"png", "svg"};  ///< formats: these, tif, asc, csv
  std::string plants;                           ///< "N" or "N/ha"; empty: none
  std::uint64_t seed = 0;                       ///< of plants
  std::string as_printed;                       ///< errata put back in, "all"; empty: none
  std::string engine;                           ///< empty: as the site file says
  int threads = 1;
  bool example = false;
  bool json = false;
};
int terrain(const TerrainOptions& options);

struct DoctorOptions {
  bool json = false;
};
int doctor(const DoctorOptions& options);

}  // namespace phytobench::cli
