// SPDX-License-Identifier: MIT
// What several subcommands read from options and show.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry/point2.hpp"

namespace phytobench::cli {

/// Squares and cubes of distances in it must neither vanish nor end: sides of 1e-50 to 1e50. Throws
/// InputError that begins with `whose`.
void refuse_odd_size(const Rectangle& window, const std::string& whose);

/// "x0,y0,x1,y1" with x0 < x1 and y0 < y1. Throws InputError naming the option.
Rectangle rectangle_from(const std::string& text, const std::string& option);

/// As text; bytes that are no UTF-8, as in file names, become question marks of Unicode.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);
std::string json_text(const nlohmann::json& json, int indent = 2);

/// For texts: without the sign of a zero.
double shown(double number);

/// "1.50 ms".
std::string with_unit(double seconds);

}  // namespace phytobench::cli
