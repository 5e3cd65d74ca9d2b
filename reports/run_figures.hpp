// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/artifact_plots.hpp"
#include "reports/document_places.hpp"
#include "reports/svg_text.hpp"

namespace phytobench {

/// Whether the artifact `a` is shown before `b`: figures by the number in their name
/// (`figure-4.7-step-40`, `figures-7.6-7.7`), then all others by name.
bool is_figure_before(const std::string& a, const std::string& b);

/// Name below the report's folder under which a picture of the run is kept: of its whole path, so
/// that pictures of two experiments differ.
std::string figure_file(const std::string& artifact);

/// Pictures of a run, and the numbers and captions of those that are plots, by artifact name: a
/// plot and its data have one name, but for the endings .svg and .csv.
struct FigureSources {
  const std::map<std::string, std::string>& pictures;   ///< SVG text
  const std::map<std::string, std::string>& plot_data;  ///< CSV text
  /// Of plots, drawn or not, by the picture's name; any other picture says it in its SVG.
  std::map<std::string, PlotCaption> captions = {};
};

/// The figures of one work, in order, for the templates, each with the claims about it. `svg` is
/// empty where it would make the page too large (`file` holds it all), and where a plot could not
/// be drawn; it has its caption then, too.
nlohmann::ordered_json figures_of(const std::string& paper, const FigureSources& sources,
                                  const ClaimIndex& claims);

/// The same for JPEG files, whose names are their labels: `source` holds one as a data URI.
nlohmann::ordered_json photographs_of(const std::string& paper,
                                      const std::map<std::string, std::string>& photographs,
                                      const ClaimIndex& claims);

}  // namespace phytobench
