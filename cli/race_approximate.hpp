// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/nearest_node/approximate_lane.hpp"

namespace phytobench::cli {

/// One object per entry: times beside what is lost of the tree.
nlohmann::ordered_json approximate_json(const std::vector<ApproximateEntry>& lane, int threads);

/// The same as a table of its own, so that nobody ranks these with exact engines.
std::string approximate_table(const std::vector<ApproximateEntry>& lane);

}  // namespace phytobench::cli
