// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/record/plot_data.hpp"
#include "experiments/experiment.hpp"

namespace phytobench {

/// Leaves a plot as the artifacts <name>.plot.json and <name>.csv, from which reports draw it. Of
/// curves of more than 150 points those are left out that nobody sees: of a line what lies nearer
/// than 1/4000 of the axes to the line through the rest, of points all but one in a cell of 1/500
/// of both axes. Throws ContractViolation for an unsound plot (plot_problem), and for one whose
/// points take more than 60 KB nevertheless.
void add_plot(ExperimentContext& context, const std::string& name, PlotData plot);

}  // namespace phytobench
