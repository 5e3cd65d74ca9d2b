// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

namespace engines {
#define ENGINE(name, dependency) extern const EngineDescriptor name;
#include "benchmarks/broken/broken_engines.def"
#undef ENGINE
}  // namespace engines

/// Every engine of broken_engines.def; the first is the one that is not broken.
inline std::vector<const EngineDescriptor*> broken_engines() {
  return {
#define ENGINE(name, dependency) &engines::name,
#include "benchmarks/broken/broken_engines.def"
#undef ENGINE
  };
}

}  // namespace phytobench
