// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands.hpp"

namespace phytobench::cli {

/// Tables of the benchmark that options.names names: one for each quantity, or for the one asked
/// for. Throws InputError with the nearest name where there is none.
int show_history(const HistoryOptions& options);

/// The same as pictures; with options.out one quantity as an SVG, too.
int plot_history(const HistoryOptions& options);

}  // namespace phytobench::cli
