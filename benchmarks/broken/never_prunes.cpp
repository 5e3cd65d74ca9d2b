// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

namespace {

struct Unpruned : Unbroken {
  static bool is_worth_opening(double, const NearestHit&) { return true; }
};

}  // namespace

extern const EngineDescriptor never_prunes;
constinit const EngineDescriptor never_prunes{
    .name = "never_prunes",
    .summary = "Broken on purpose: opens every block, however far away.",
    .source = "a condition lost when code was moved",
    .create = make_point_driven_engine<BlockedScan<Unpruned>>,
};

}  // namespace phytobench::engines
