// SPDX-License-Identifier: MIT
// Stands in for flann_randomised.cpp where FLANN was not found.
#include "benchmarks/nearest_node/flann_randomised.hpp"

namespace phytobench {

namespace {

constexpr EngineDescriptor not_built(std::string_view name) {
  return {.name = name,
          .summary = "Not built: FLANN is missing.",
          .source = "see benchmarks/nearest_node/flann_randomised.cpp",
          .missing_package = "flann"};
}

constexpr EngineDescriptor missing_engines[] = {
    not_built("flann_randomised_16"),
    not_built("flann_randomised_64"),
    not_built("flann_randomised_256"),
};

}  // namespace

std::span<const EngineDescriptor> approximate_engines() {
  return missing_engines;
}

}  // namespace phytobench
