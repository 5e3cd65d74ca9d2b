// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "experiments/experiment_registry.hpp"
#include "reports/write_report.hpp"

namespace phytobench::cli {

namespace {

/// A report of several runs belongs to none of them.
std::string out_folder(const ReportOptions& options) {
  if (!options.out.empty()) return options.out;
  if (options.folders.size() > 1)
    throw InputError("say where the report of several runs goes, with --out FOLDER");
  return options.folders.front() + "/report";
}

/// What the report says about experiments besides their measurements.
std::map<std::string, ExperimentFacts> experiment_facts() {
  std::map<std::string, ExperimentFacts> facts;
  for (const ExperimentDescriptor* experiment : all_experiments()) {
    ExperimentFacts& own = facts[std::string(experiment->id)];
    own.question = experiment->question;
    own.source = experiment->source;
    std::copy(std::begin(experiment->seconds), std::end(experiment->seconds), own.seconds);
  }
  return facts;
}

}  // namespace

int report(const ReportOptions& options) {
  const std::string out = out_folder(options);
  const ReportSummary summary =
      write_report({.run_folders = {options.folders.begin(), options.folders.end()},
                    .out_folder = out,
                    .formats = options.formats,
                    .without_varying = options.without_varying,
                    .experiments = experiment_facts()});
  print(fmt::format("{}written to {}\n", summary.text, out));
  if (summary.unexpected > 0) return 1;
  return options.strict && summary.inconclusive > 0 ? 5 : 0;
}

}  // namespace phytobench::cli
