// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/artifact_plots.hpp"
#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// An artifact of a run that can be shown, or what is drawn from one.
struct Picture {
  std::filesystem::path file;  ///< where it lies; empty: it was drawn for the report
  std::string bytes;
};

/// Everything a report is made from: runs, read and judged.
struct ReportInput {
  JudgedRun judged;                         ///< of several runs: merged
  std::optional<RunComparison> comparison;  ///< of several runs only
  std::vector<std::filesystem::path> run_folders;
  std::vector<std::string> environments;       ///< environment.json of each run
  std::map<std::string, Picture> drawings;     ///< SVG, by their path below artifacts/
  std::map<std::string, Picture> photographs;  ///< JPEG, the same
  std::map<std::string, Picture> plot_data;    ///< CSV files of plots, the same
  /// Of plots, drawn or not, by their picture's path below artifacts/.
  std::map<std::string, PlotCaption> captions;
};

struct ReportInputOptions {
  bool pictures = true;          ///< read and draw them
  bool without_varying = false;  ///< label several runs by their place, not by their machine
};

/// Reads and judges the runs; several are merged. Of an artifact that several runs left, the first
/// run's is taken; files that no complete experiment of a run has sealed are none. The merged run
/// is `unfinished` where an experiment breaks off in one run and is complete in none. Throws
/// InputError for a folder without a run, and where one run is given twice.
ReportInput read_report_input(const std::vector<std::filesystem::path>& run_folders,
                              const ReportInputOptions& options);

}  // namespace phytobench
