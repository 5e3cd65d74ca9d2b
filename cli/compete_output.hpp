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
/// mean_nearest_distance} or null: below 10 plants, and above 20,000 unless it was asked for;
/// pairs, pairs_per_step; files. Lengths in m; null where there is nothing to take a mean of, and
/// for the Gini coefficient of fewer than two plants.
///
/// The loss of a plant is the share of its growth space that neighbours take. Most rules sum over
/// pairs, so that ground on which several neighbours lie counts once for each and a loss may exceed
/// 1; growth stops at 0.5. oppressed_share is the part of the living plants whose loss is above
/// 0.5; resting_seeds are seeds at rest in the soil at the end; pairs counts the overlaps of two
/// plants' zones that the rule looked at, of roots and of crowns, summed over all steps.
std::string compete_json(const CompeteFindings& findings, const CompeteOptions& options);
std::string compete_text(const CompeteFindings& findings, const CompeteOptions& options);

}  // namespace phytobench::cli
