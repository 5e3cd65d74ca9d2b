// SPDX-License-Identifier: MIT
// One function per subcommand, each in a file of its own. Options are plain structs: only main.cpp
// knows the command-line library.
#pragma once

#include <cstdint>
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
  std::string folder;
  std::string out;  ///< empty: <folder>/report
  std::vector<std::string> formats{"html", "md", "csv"};
  bool without_varying = false;
  bool strict = false;
};
int report(const ReportOptions& options);

struct GrowOptions {
  std::string config;
  std::string engine = "voxel_grid";
  std::string option = "dn";
  int threads = 1;
  std::string picture;  ///< SVG file; empty: none
  bool example = false;
  bool json = false;
};
int grow(const GrowOptions& options);

struct DoctorOptions {
  bool json = false;
};
int doctor(const DoctorOptions& options);

}  // namespace phytobench::cli
