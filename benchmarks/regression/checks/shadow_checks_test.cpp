// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/shadow_checks.hpp"

#include <gtest/gtest.h>

#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench {
namespace {

TEST(ShadowChecks, SeeASingleWrongRayAndCountShares) {
  const ShadowWorkload workload =
      fractal_shadows({.size = 40, .relief = 120.0, .hours = 5, .seed = 4});
  LitMaps lit;
  shadow_engine_named("exact_traversal").create()->cast(workload.field, workload.suns, {}, lit);
  EXPECT_EQ(objection_to_shadows(workload, lit, 0.0), "");
  lit.row(1, 20)[0] ^= std::uint64_t{1} << 17;
  EXPECT_EQ(objection_to_shadows(workload, lit, 0.0),
            "1 of 8000 rays end otherwise than they must");
  EXPECT_EQ(objection_to_shadows(workload, lit, 1.0 / 8000), "");
  for (std::size_t position = 0; position < 5; ++position) lit.light_all(position);
  EXPECT_NE(objection_to_shadows(workload, lit, 0.01), "");
}

TEST(ShadowChecks, RefuseMapsOfAnotherShape) {
  const ShadowWorkload workload = fractal_shadows({.size = 10, .relief = 20.0, .hours = 3});
  EXPECT_NE(objection_to_shadows(workload, {}, 1.0), "");
  EXPECT_NE(objection_to_shadows(workload, LitMaps(10, 10, 2), 1.0), "");
}

}  // namespace
}  // namespace phytobench
