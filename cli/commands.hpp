// SPDX-License-Identifier: MIT
// One function per subcommand, each in a file of its own. Options are plain structs: only main.cpp
// knows the command-line library.
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

struct GrowOptions {
  std::string config;
  std::string preset;  ///< instead of a file
  std::string engine = "node_driven";
  std::string option = "dn";
  int threads = 1;
  std::vector<std::string> out;  ///< .obj or .glb files
  bool split = false;            ///< meshes of at most 65,536 vertices
  std::string picture;           ///< .png of the plant or .svg of the skeleton; empty: none
  double azimuth_deg = 90.0;
  double elevation_deg = 8.0;
  double distance = 0.0;  ///< 0: the whole plant fits
  int picture_height = 800;
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
  std::string cloud;  ///< CSV file; empty: the scaled test tree
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

struct OverlapOptions {
  std::string discs;         ///< CSV file
  std::string radius = "r";  ///< its column of radii
  std::string window;        ///< x0,y0,x1,y1; empty: the open plane
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

struct DoctorOptions {
  bool json = false;
};
int doctor(const DoctorOptions& options);

}  // namespace phytobench::cli
