// SPDX-License-Identifier: MIT
// The kinds of components, as `list components` and `build --example list` show them.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench::cli {

/// An entry for each: id, source, built, missing_package, is_multiplier, carries_branches, keys
/// (name, unit, meaning, source, default), summary.
nlohmann::ordered_json component_rows();

/// A line for each: its name and what it does.
std::string component_list_text();

}  // namespace phytobench::cli
