// SPDX-License-Identifier: MIT
// Plugins as sides of what is timed.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/worker_client.hpp"

namespace phytobench::cli {

/// A plugin runs inside the worker that times it. Before that it must show in a process of its own
/// that it is fit to. What is wrong with it, in one line with its end; empty if nothing, or if the
/// side is no plugin. Throws InputError for one that cannot be loaded.
std::string failed_trial(const Side& side);

/// What can be timed of a side; of a plugin only what its engine brings, for all else is this
/// program.
std::vector<std::string> names_of(WorkerClient& client);

}  // namespace phytobench::cli
