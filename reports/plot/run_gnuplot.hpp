// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace phytobench {

/// The SVG file that gnuplot (`program`: its name or path) makes of a script; nothing if there is
/// no such program. Throws EnvironmentError if it fails or draws nothing.
std::optional<std::string> run_gnuplot(std::string program, const std::string& script);

}  // namespace phytobench
