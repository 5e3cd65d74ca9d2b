// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

extern const EngineDescriptor blocked_scan;
constinit const EngineDescriptor blocked_scan{
    .name = "blocked_scan",
    .summary = "Looks at every node of the blocks whose boxes are near enough.",
    .source = "what the others break",
    .create = make_point_driven_engine<BlockedScan<Unbroken>>,
};

}  // namespace phytobench::engines
