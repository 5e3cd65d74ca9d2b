// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Whether any killer lies within the squared distance of the point. Looks at all of them, without
/// early exit, as the thesis' rows do. One function in one place, so that every engine's default
/// removal runs the very same machine code: compiled once per engine, its speed differed by a third
/// from row to row.
bool is_reached_by_any(const Vector3& point, std::span<const SearchableNode> killers,
                       double squared_reach);

}  // namespace phytobench
