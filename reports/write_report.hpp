// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/document_costs.hpp"
#include "reports/report_summary.hpp"

namespace phytobench {

struct ReportRequest {
  std::vector<std::filesystem::path> run_folders;  ///< several are merged into one report
  std::filesystem::path out_folder;
  std::vector<std::string> formats;  ///< "html", "md", "latex", "csv", "junit"
  bool without_varying = false;      ///< leave out times and machine: equal runs give equal bytes
  std::map<std::string, ExperimentFacts> experiments;  ///< by id; what is absent is not known
};

/// Judges the runs and puts verdicts.json, the formats asked for and SHA256SUMS into the folder, in
/// place of an earlier report there. Throws InputError for an unknown format, a folder without
/// records or a run that is given twice, EnvironmentError where nothing can be written; what was
/// there is unchanged then.
ReportSummary write_report(const ReportRequest& request);

}  // namespace phytobench
