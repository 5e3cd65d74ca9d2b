// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// Appends a module as it is written, with the shortest digits that give the same numbers back:
/// "A(2,0.5)".
void append_module(std::string& text, const Symbol& symbol, const double* parameters);

/// The same alone.
std::string module_text(const Symbol& symbol, const double* parameters);

}  // namespace phytobench
