// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "reports/judge/scaling.hpp"

namespace phytobench {

/// Pictures of a scaling study as SVG text: "<study>-time" and "<study>-work". Those without a
/// curve, and all if gnuplot is not installed, are left out.
std::map<std::string, std::string> scaling_plots(const JudgedScaling& scaling,
                                                 bool without_varying);

/// What these pictures show, as CSV (series,x,y,low,high), by the same names; with gnuplot or
/// without.
std::map<std::string, std::string> scaling_plot_data(const JudgedScaling& scaling,
                                                     bool without_varying);

}  // namespace phytobench
