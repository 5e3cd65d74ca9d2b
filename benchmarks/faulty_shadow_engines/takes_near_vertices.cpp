// SPDX-License-Identifier: MIT
#include <limits>

#include "benchmarks/faulty_shadow_engines/right_maps.hpp"

namespace phytobench::shadow_engines {

namespace {

ShadowWork cast(const HeightField& field, const SunDirection& sun, const ShadowSetup&,
                std::size_t position, LitMaps& lit) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  return light_rays(field, sun, position, all, lit,
                    [](const RayCrossing& crossing, const double* from) {
                      return from[crossing.near] > *from + crossing.rise;
                    });
}

}  // namespace

extern const ShadowEngineDescriptor takes_near_vertices;
constinit const ShadowEngineDescriptor takes_near_vertices{
    .name = "takes_near_vertices",
    .summary = "Wrong on purpose: takes a vertex' height for that of the line beside it.",
    .source = "a missing interpolation",
    .create = shadow_engine_from<cast>,
};

}  // namespace phytobench::shadow_engines
