// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/overlap/discs.hpp"

namespace phytobench {

/// Discs that own their numbers.
struct DiscTable {
  std::vector<double> x, y, radius;

  Discs discs() const { return {x, y, radius}; }
};

/// "r", or "radius", as other tables of plants call it, where a file has that and no r. A pipe can
/// be read only once: "r".
std::string usual_radius_column(const std::filesystem::path& file);

/// A CSV file with columns x, y and one of radii (others are ignored). Throws InputError with
/// file:line for everything that read_number_columns() refuses, and for discs that no engine can
/// take: see problem_with().
DiscTable read_discs(const std::filesystem::path& file, const Ground& ground,
                     const std::string& radius_column = "r");

}  // namespace phytobench
