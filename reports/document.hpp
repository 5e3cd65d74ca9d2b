// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_costs.hpp"
#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"
#include "reports/run_figures.hpp"

namespace phytobench {

/// What is added to the judged run from the run's folder and from the program.
struct DocumentSources {
  std::string environment_json;
  std::string run_folder;                       ///< as the user named it, for the repeat commands
  std::map<std::string, std::string> pictures;  ///< artifact name -> SVG text
  std::map<std::string, std::string> photographs;  ///< artifact name -> bytes of a JPEG file
  std::map<std::string, std::string> plots;        ///< made for this report: name -> SVG text
  bool without_varying = false;
  std::map<std::string, std::string> plot_data = {};  ///< numbers of plots: artifact name -> CSV
  std::map<std::string, ExperimentFacts> experiments = {};  ///< by id; what is absent is not known
  const RunComparison* comparison = nullptr;                ///< of a merged run
  std::map<std::string, PlotCaption> captions = {};         ///< of plots, by their picture's name
};

/// The one document model: everything a report says, ready for the templates. The templates only
/// arrange. Whoever has more to say adds `comparison` and `has_comparison`, `validation` and
/// `has_validation` to it.
nlohmann::ordered_json make_document(const JudgedRun& judged, const DocumentSources& sources);

}  // namespace phytobench
