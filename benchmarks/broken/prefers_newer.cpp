// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

namespace {

struct OtherTies : Unbroken {
  static bool wins(double squared, NodeIndex, const NearestHit& best) {
    return squared <= best.squared_distance;
  }
};

}  // namespace

extern const EngineDescriptor prefers_newer;
constinit const EngineDescriptor prefers_newer{
    .name = "prefers_newer",
    .summary = "Broken on purpose: of equally near nodes it takes the newest.",
    .source = "a <= where a < belongs",
    .create = make_point_driven_engine<BlockedScan<OtherTies>>,
};

}  // namespace phytobench::engines
