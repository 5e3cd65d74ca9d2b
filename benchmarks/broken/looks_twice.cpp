// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

namespace {

struct Wasteful : Unbroken {
  static std::size_t looks(std::size_t node) { return node % 20 == 19 ? 2 : 1; }
};

}  // namespace

extern const EngineDescriptor looks_twice;
constinit const EngineDescriptor looks_twice{
    .name = "looks_twice",
    .summary = "Broken on purpose: looks at every twentieth node of a block twice.",
    .source = "a loop that overlaps its neighbour",
    .create = make_point_driven_engine<BlockedScan<Wasteful>>,
};

}  // namespace phytobench::engines
