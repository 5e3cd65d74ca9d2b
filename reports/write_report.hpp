// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace phytobench {

struct ReportRequest {
  std::filesystem::path run_folder;
  std::filesystem::path out_folder;
  std::vector<std::string> formats;  ///< "html", "md", "csv"
  bool without_varying = false;      ///< leave out times and machine: equal runs give equal bytes
};

struct ReportSummary {
  std::string text;            ///< a few lines for the terminal
  std::size_t unexpected = 0;  ///< verdicts that differ from the expected one
  std::size_t inconclusive = 0;
};

/// Judges a run and writes verdicts.json and the formats asked for. Throws InputError for an
/// unknown format or a folder without records.
ReportSummary write_report(const ReportRequest& request);

}  // namespace phytobench
