// SPDX-License-Identifier: MIT
// How `phytobench compete` says what it found.
#pragma once

#include <string>

#include "cli/commands.hpp"
#include "cli/compete_findings.hpp"

namespace phytobench::cli {

/// Schema phytobench/compete-1: config, preset, plants (as given, or null), seed, rule, engine,
/// steps; ground {corner, size, torus, area}; species [{name, start, born, died, alive,
/// resting_seeds, density, mean_radius, largest_radius, basal_area, gini, mean_loss,
/// oppressed_share}] and all, the same without a name; pattern {clark_evans, hopkins,
/// mean_nearest_distance} or null; pairs, pairs_per_step; files. Lengths in m; null where there is
/// nothing to take a mean of.
std::string compete_json(const CompeteFindings& findings, const CompeteOptions& options);
std::string compete_text(const CompeteFindings& findings, const CompeteOptions& options);

}  // namespace phytobench::cli
