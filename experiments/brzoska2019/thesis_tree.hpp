// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/colonization/tree_parameters.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::brzoska2019 {

/// parameters.toml of the thesis.
TomlTable thesis_parameters();

/// A tree of parameters.toml ("figure-51"), with keys replaced by those of a further table, if any.
TreeParameters thesis_tree(const std::string& name, const std::string& replacing_table = "");

}  // namespace phytobench::experiments::brzoska2019
