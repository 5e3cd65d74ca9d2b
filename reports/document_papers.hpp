// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_costs.hpp"
#include "reports/judge/judged_run.hpp"
#include "reports/run_figures.hpp"

namespace phytobench {

/// What the section on a work is made from besides its judgements.
struct PaperSources {
  const RunContents& run;
  const Evidence& evidence;
  const ExperimentCosts& costs;
  FigureSources figures;
  const std::map<std::string, std::string>& photographs;  ///< artifact name -> bytes of a JPEG file
  bool without_varying = false;
};

/// Whether any experiment of a work is in the run.
bool is_in_run(const RunContents& run, const std::string& paper);

/// The section on one work: counts, places, tables, figures, claims by topic, errata, assumptions.
nlohmann::ordered_json paper_document(const JudgedPaper& judged, const PaperSources& sources);

}  // namespace phytobench
