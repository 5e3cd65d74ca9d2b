// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/record/run_files.hpp"

namespace phytobench {

/// How much repetitions of equal work scatter: |later / earlier - 1| of neighbouring rounds.
struct Scatter {
  std::size_t pairs = 0;
  double typical = 0.0;        ///< median
  double one_in_twenty = 0.0;  ///< 95 % quantile
};

/// Of one measurement's samples in the order of rounds.
std::vector<double> round_changes(std::span<const double> samples);

/// Of such changes, of one measurement or of many. None gives no pairs.
Scatter scatter_of(std::span<const double> changes);

/// Every time of the run with its interval (its range, of few rounds), by experiment, and the noise
/// floor of each experiment: a ratio of two times closer to 1 than that says nothing. Costs of
/// experiments are left out.
nlohmann::ordered_json timings_document(const RunContents& run, bool without_varying);

}  // namespace phytobench
