// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_shadow_engines/right_maps.hpp"

namespace phytobench::shadow_engines {

namespace {

ShadowWork cast(const HeightField& field, const SunDirection& sun, const ShadowSetup&,
                std::size_t position, LitMaps& lit) {
  constexpr std::size_t most = 6;
  return light_rays(field, sun, position, most, lit,
                    [](const RayCrossing& crossing, const double* from) {
                      return height_at(crossing, from) > *from + crossing.rise;
                    });
}

}  // namespace

extern const ShadowEngineDescriptor looks_too_near;
constinit const ShadowEngineDescriptor looks_too_near{
    .name = "looks_too_near",
    .summary = "Wrong on purpose: rays end after a few cells.",
    .source = "a reach that was thought enough",
    .create = shadow_engine_from<cast>,
};

}  // namespace phytobench::shadow_engines
