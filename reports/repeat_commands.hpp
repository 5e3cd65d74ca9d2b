// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/record/record.hpp"
#include "core/record/run_files.hpp"
#include "reference/claims.hpp"

namespace phytobench {

/// A command that makes a run again, into that folder. `experiments` empty: all.
std::string repeat_run(const std::vector<std::string>& experiments, const RunHeader& header,
                       const std::string& folder);

/// The experiments whose measurements a claim is judged on, each once, in the order of its checks.
std::vector<std::string> experiments_of(const Claim& claim);

/// A command that measures these experiments alone. Its folder is of these experiments and this
/// tier only, since a run refuses a folder that holds another. The usual seed, 0, is not named.
std::string repeat_experiments(const std::vector<std::string>& experiments, Tier tier,
                               std::uint64_t seed = 0);

}  // namespace phytobench
