// SPDX-License-Identifier: MIT
#include "reports/write_report.hpp"

#include "reports/report_files.hpp"

namespace phytobench {

ReportSummary write_report(const ReportRequest& request) {
  const ReportFilesOptions options{.formats = report_formats_named(request.formats),
                                   .without_varying = request.without_varying,
                                   .folder = request.out_folder,
                                   .experiments = request.experiments};
  const ReportInput input = read_report_input(
      request.run_folders,
      {.pictures = options.formats.has_pictures(), .without_varying = request.without_varying});
  put_report(request.out_folder, report_files(input, options));
  return report_summary(input.judged);
}

}  // namespace phytobench
