// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/colonization/tree_parameters.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::brzoska2019 {

/// parameters.toml of the thesis.
TomlTable thesis_parameters();

/// A preset of the thesis ("figure-51"), with keys replaced by those of a table of parameters.toml,
/// if any.
TreeParameters thesis_tree(const std::string& name, const std::string& replacing_table = "");

/// The skeleton of such a tree, grown with the default engine.
Skeleton grow_thesis_tree(const TreeParameters& parameters, int threads);

}  // namespace phytobench::experiments::brzoska2019
