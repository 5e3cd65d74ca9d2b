// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"

namespace phytobench {

/// Every experiment of experiments.def, in that order.
std::span<const ExperimentDescriptor* const> all_experiments();

/// Those whose id matches one of the patterns ('*' any text, '?' any character); all for none. An
/// id without wildcard that does not exist is an InputError, a wildcard that matches nothing
/// NothingSelected.
std::vector<const ExperimentDescriptor*> selected_experiments(
    const std::vector<std::string>& patterns);

}  // namespace phytobench
