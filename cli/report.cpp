// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "reports/write_report.hpp"

namespace phytobench::cli {

int report(const ReportOptions& options) {
  const std::string out = options.out.empty() ? options.folder + "/report" : options.out;
  const ReportSummary summary = write_report({.run_folder = options.folder,
                                              .out_folder = out,
                                              .formats = options.formats,
                                              .without_varying = options.without_varying});
  print(fmt::format("{}written to {}\n", summary.text, out));
  if (summary.unexpected > 0) return 1;
  return options.strict && summary.inconclusive > 0 ? 5 : 0;
}

}  // namespace phytobench::cli
