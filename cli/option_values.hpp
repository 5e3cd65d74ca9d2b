// SPDX-License-Identifier: MIT
// What several subcommands read from options and show.
#pragma once

#include <string>

#include "core/geometry/point2.hpp"

namespace phytobench::cli {

/// "x0,y0,x1,y1" with x0 < x1 and y0 < y1. Throws InputError naming the option.
Rectangle rectangle_from(const std::string& text, const std::string& option);

/// "1.50 ms".
std::string with_unit(double seconds);

}  // namespace phytobench::cli
