// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// What is added to the judged run from the run's folder.
struct DocumentSources {
  std::string environment_json;
  std::string run_folder;                       ///< as the user named it, for the repeat commands
  std::map<std::string, std::string> pictures;  ///< artifact name -> SVG text
  std::map<std::string, std::string> photographs;  ///< artifact name -> bytes of a JPEG file
  std::map<std::string, std::string> plots;        ///< made for this report: name -> SVG text
  bool without_varying = false;
};

/// Name below the report's folder under which a picture of the run is kept.
std::string figure_file(const std::string& artifact);

/// The one document model: everything a report says, ready for the templates. The templates only
/// arrange.
nlohmann::ordered_json make_document(const JudgedRun& judged, const DocumentSources& sources);

}  // namespace phytobench
