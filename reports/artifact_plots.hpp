// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/record/plot_data.hpp"

namespace phytobench {

/// What a plot says of itself, drawn or not.
struct PlotCaption {
  std::string title;        ///< what is shown
  std::string description;  ///< what is seen
};

/// A plot that an experiment left as data, drawn.
struct ArtifactPlot {
  std::string svg;  ///< ids begin with the slug of its name; empty: gnuplot is not installed
  PlotCaption caption;
  std::filesystem::path data_file;  ///< the CSV file
  std::string data_name;            ///< its name below artifacts/
  std::string data;                 ///< its content
};

/// The plots (*.plot.json, each with its CSV file beside it) among a run's sealed `artifacts`,
/// which are given by their path below artifacts/; by that path as if the picture were there:
/// "alsweis/two-plants/figure-4.5.svg". Where `gnuplot` (a program's name or path) is not
/// installed, they are there without a picture. Throws InputError with file and line or key for a
/// file that is broken or no plot of ours.
std::map<std::string, ArtifactPlot> artifact_plots(const std::filesystem::path& run_folder,
                                                   const std::set<std::string>& artifacts,
                                                   const std::string& gnuplot = "gnuplot");

/// The picture; nothing if gnuplot is not installed. `id` of letters, digits and '-'.
std::optional<std::string> draw_plot(const PlotData& plot, const std::string& id,
                                     const std::string& gnuplot = "gnuplot");

/// The points as a table to be shown on a page.
struct DataTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Of the CSV file of a plot or a scaling plot; without rows if it has more than `most_rows`.
DataTable data_table(const std::string& csv, std::size_t most_rows = 60);

}  // namespace phytobench
