// SPDX-License-Identifier: MIT
// The kinds of components, as `list components` and `build --example` show them.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench::cli {

/// An entry for each: id, source, built, missing_package, is_multiplier, carries_branches, keys
/// (name, unit, meaning, source, default), summary.
nlohmann::ordered_json component_rows();

/// What `build --example` prints: a graph that explains this kind of component, the file of this
/// preset, or, for "list", a line for each of both. Throws InputError with the closest name.
std::string component_example(const std::string& name);

}  // namespace phytobench::cli
