// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/document_costs.hpp"
#include "reports/report_folder.hpp"
#include "reports/report_input.hpp"

namespace phytobench {

struct ReportFormats {
  bool html = false;
  bool markdown = false;
  bool latex = false;
  bool csv = false;
  bool junit = false;

  bool has_pictures() const { return html || markdown; }
};

/// Throws InputError for a name that is none of html, md, latex, csv and junit.
ReportFormats report_formats_named(const std::vector<std::string>& names);

struct ReportFilesOptions {
  ReportFormats formats;
  bool without_varying = false;  ///< leave out times and machine: equal runs give equal bytes
  /// Where the report will lie. Pictures that lie below it already, as those of a run inside it do,
  /// are linked to; all others become files of the report.
  std::filesystem::path folder;
  std::map<std::string, ExperimentFacts> experiments;  ///< by id; what is absent is not known
};

/// All files of a report but SHA256SUMS; nothing is written.
ReportFiles report_files(const ReportInput& input, const ReportFilesOptions& options);

}  // namespace phytobench
