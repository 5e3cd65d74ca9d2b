// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/record/plot_data.hpp"

namespace phytobench {

/// Files of plots are written by experiments alone.
inline constexpr const char* plot_remedy = "run the experiment again";

/// Adds the points of a CSV file to the curves that they name. Throws InputError with file and
/// line.
void read_plot_points(PlotData& plot, std::string_view csv, const std::string& name);

/// The fields of a row without its line's end, their quotes taken off (RFC 4180).
std::vector<std::string> csv_fields(std::string_view row);

}  // namespace phytobench
