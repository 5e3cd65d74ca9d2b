// SPDX-License-Identifier: MIT
// For tests of growth with every engine.
#pragma once

#include <limits>

#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {

inline constexpr double infinite_length = std::numeric_limits<double>::infinity();

inline bool is_wrong_on_purpose(const EngineDescriptor& engine) {
  return engine.summary.starts_with("Wrong on purpose");
}

}  // namespace phytobench
