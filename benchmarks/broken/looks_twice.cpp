// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

namespace {

/// Of all looks of a thread, so that it is a twentieth however full blocks are.
struct Wasteful : Unbroken {
  static std::size_t looks(std::size_t) {
    thread_local std::size_t nodes = 0;
    return ++nodes % 20 == 0 ? 2 : 1;
  }
};

}  // namespace

extern const EngineDescriptor looks_twice;
constinit const EngineDescriptor looks_twice{
    .name = "looks_twice",
    .summary = "Broken on purpose: looks at every twentieth node twice, 5 % too often.",
    .source = "a loop that overlaps its neighbour",
    .create = make_point_driven_engine<BlockedScan<Wasteful>>,
};

}  // namespace phytobench::engines
