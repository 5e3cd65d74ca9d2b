// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/plot/line_plot.hpp"

namespace phytobench {

/// What gnuplot is to do for a sound plot: its series in order, then the error bars of those that
/// have some.
std::string gnuplot_script(const LinePlot& plot);

}  // namespace phytobench
