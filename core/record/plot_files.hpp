// SPDX-License-Identifier: MIT
// A plot as files: <name>.plot.json says how it is drawn, <name>.csv beside it holds its points.
#pragma once

#include <string>
#include <string_view>

#include "core/record/plot_data.hpp"

namespace phytobench {

inline constexpr std::string_view plot_schema = "phytobench/plot-1";

/// The content of <name>.plot.json: all but the points. The plot must have no plot_problem.
std::string plot_json(const PlotData& plot);

/// The content of <name>.csv, a point per row: [panel,]series,x,y[,low,high], panels counted from 1
/// and named where there are several; an empty y breaks the line. Numbers have six digits.
std::string plot_csv(const PlotData& plot);

/// The texts of both files; the names are for messages. Throws InputError with file and key, or
/// file and line, for what is no such plot.
PlotData parse_plot(const std::string& json, const std::string& json_name, const std::string& csv,
                    const std::string& csv_name);

}  // namespace phytobench
