// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace phytobench {

/// An SVG of gnuplot's in a third to two thirds of its bytes, for a page that holds many: without
/// empty groups and marks that nothing uses, and with dots one after another as one path. Looks the
/// same.
std::string smaller_svg(const std::string& drawn);

}  // namespace phytobench
