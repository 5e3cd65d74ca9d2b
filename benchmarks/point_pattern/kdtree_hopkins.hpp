// SPDX-License-Identifier: MIT
// The way the index is usually computed: random places and points ask a k-d tree of the points.
#pragma once

#include <span>
#include <string_view>

#include "core/point_pattern/hopkins.hpp"

namespace phytobench {

/// Library and version; empty if it was not found when phytobench was configured.
std::string_view kdtree_library();

/// hopkins_sampled() at the given places, in a window with edges. Expects a library.
HopkinsIndex kdtree_hopkins(std::span<const Point2> points, std::span<const Point2> places);

}  // namespace phytobench
