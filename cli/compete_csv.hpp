// SPDX-License-Identifier: MIT
// The tables that `phytobench compete` writes, and the curves drawn from one of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/compete_findings.hpp"

namespace phytobench::cli {

/// steps.csv: its first line, and one line for each species and one for all at one step.
std::string steps_header();
std::string steps_rows(const Population& population, const StandStatistics& statistics,
                       const std::vector<std::uint64_t>& start);
/// Plants, Gini coefficient and mean stem radius over the steps of a whole steps.csv, as SVG, in
/// the hues that species have in pictures of stands; plants count from 0.
std::string curves_of(std::string_view steps_csv, const std::vector<std::string>& species);

/// plants.csv: all plants in the order of their ids.
std::string plants_csv(const CompeteFindings& findings);

}  // namespace phytobench::cli
