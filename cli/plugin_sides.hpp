// SPDX-License-Identifier: MIT
// Plugins as sides of what is timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison_report.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "benchmarks/nearest_node/supervised.hpp"

namespace phytobench::cli {

/// A plugin runs inside the worker that times it. Before that it must show in a process of its own
/// that it is fit to. What is wrong with it; nothing if it is fit, or if the side is no plugin.
/// `role` is "base" or "new"; a call of it may take so many seconds. Throws InputError for one that
/// cannot be loaded.
std::optional<FailedTrial> trial_of(const Side& side, const std::string& role,
                                    double call_limit_s = SupervisionLimits{}.silence_s);

/// The same of a side that is measured alone, in one line with its end; empty if nothing is wrong.
std::string failed_trial(const Side& side);

/// What can be timed of a side; of a plugin only what its engine brings, for all else is this
/// program.
std::vector<std::string> names_of(WorkerClient& client);

}  // namespace phytobench::cli
