// SPDX-License-Identifier: MIT
// The command line, put together from files that each know some of its commands.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace CLI {
class App;
}

namespace phytobench::cli {

/// Options of every command, and what the chosen one runs.
struct Commands {
  ListOptions list;
  RunOptions run;
  ReportOptions report;
  GrowOptions grow;
  NearestNodeRaceOptions nearest_node_race;
  OverlapRaceOptions overlap_race;
  HopkinsRaceOptions hopkins_race;
  CompetitionRaceOptions competition_race;
  LSystemRaceOptions lsystem_race;
  ShadowRaceOptions shadow_race;
  PlantBuildOptions build;
  LSystemDeriveOptions derive;
  OverlapOptions overlap;
  PatternOptions pattern;
  CompeteOptions compete;
  TerrainOptions terrain;
  DoctorOptions doctor;
  CompareOptions compare;
  SelftestOptions selftest;
  HistoryOptions history;
  BenchListOptions bench_list;
  BenchCountersOptions bench_counters;
  BenchInstructionsOptions bench_instructions;
  BenchMeasureOptions bench_measure;
  std::function<int()> chosen = {};
};

void add_list(CLI::App& app, Commands& commands);
void add_run(CLI::App& app, Commands& commands);
void add_report(CLI::App& app, Commands& commands);
void add_grow(CLI::App& app, Commands& commands);
void add_race(CLI::App& app, Commands& commands);
void add_build(CLI::App& app, Commands& commands);
void add_derive(CLI::App& app, Commands& commands);
void add_overlap(CLI::App& app, Commands& commands);
void add_pattern(CLI::App& app, Commands& commands);
void add_compete(CLI::App& app, Commands& commands);
void add_terrain(CLI::App& app, Commands& commands);
void add_doctor(CLI::App& app, Commands& commands);
void add_bench(CLI::App& app, Commands& commands);
void add_compare(CLI::App& app, Commands& commands);
void add_selftest(CLI::App& app, Commands& commands);
void add_history(CLI::App& app, Commands& commands);

/// Options of CameraOptions: from where a picture is taken.
void add_camera(CLI::App& sub, CameraOptions& options);

/// Options of the commands that time benchmarks in processes: how many samples, and how long ones.
void add_sampling(CLI::App& sub, int& samples, double& sample_ms);

/// --out of commands that write single files: comma-separated names. The library would pass over
/// empty ones and take the words that follow for more.
void add_files(CLI::App& sub, std::vector<std::string>& files, const std::string& meaning);

/// What to call when `sub` was chosen: `chosen`, or a refusal if there is more than --example.
std::function<int()> unless_example_has_company(const CLI::App& sub, std::function<int()> chosen);

/// The library would only say that some race is required. Throws InputError.
void refuse_unknown_race(int argc, char** argv);

/// For numbers of up to 64 bits: what is wrong with the text; empty if nothing. The library reads
/// "-1" as a huge unsigned number and accepts digits without end.
inline std::string whole_number(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits && text.size() <= 18 ? "" : "give a whole number of at most 18 digits";
}

/// For names of files: what is wrong with the text. Nothing would be written under an empty one.
inline std::string some_name(const std::string& text) {
  return text.empty() ? "a name is missing; give one, or leave the option out" : "";
}

/// For options that mean nothing without a value: what is wrong with the text.
inline std::string some_value(const std::string& text) {
  return text.empty() ? "a value is missing; give one, or leave the option out" : "";
}

}  // namespace phytobench::cli
