// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/contract/errors.hpp"

namespace phytobench {

/// Of one instance. A mesh is made as a whole before the plant's own limit can refuse it.
inline constexpr double most_vertices_of_instance = 1e6;

/// Throws InputError for a grid of that many vertices. `what` is "a stem".
inline void refuse_too_many_vertices(std::string_view what, int rows, int columns) {
  if (static_cast<double>(rows) * static_cast<double>(columns) <= most_vertices_of_instance) return;
  throw InputError(std::string(what) + " would have " + std::to_string(rows) + " x " +
                   std::to_string(columns) +
                   " vertices, and one component may have a million; lower its corners or pieces, "
                   "or the resolution");
}

}  // namespace phytobench
