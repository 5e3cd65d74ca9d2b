// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/record/record.hpp"

namespace phytobench {

/// The experiments that a command line of `phytobench run` names, as ids and globs, quoted for a
/// shell where needed; empty where it names none or is another command's.
std::vector<std::string> selection_of(const std::string& command_line);

/// A command that makes a run again. `selection` empty: all experiments.
std::string repeat_run(const std::vector<std::string>& selection, Tier tier, std::uint64_t seed);

/// A command that measures these experiments alone. Its folder is of these experiments and this
/// tier only, since a run refuses a folder that holds another.
std::string repeat_experiments(const std::vector<std::string>& experiments, Tier tier);

}  // namespace phytobench
