// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// A side view (x to the right, y up) of the bare skeleton as a small SVG that follows the page's
/// text colour. Lines are as wide as the pipe model makes branches with equal tips ([Brzoska2019]
/// eq. 12).
std::string skeleton_svg(const Skeleton& skeleton, const std::string& title);

}  // namespace phytobench
