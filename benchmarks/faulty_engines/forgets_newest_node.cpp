// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_engines/faulty_scan.hpp"

namespace phytobench::engines {

namespace {

struct Mistake : NoMistake {
  static std::size_t nodes_looked_at(std::size_t count) { return count > 1 ? count - 1 : count; }
};

}  // namespace

extern const EngineDescriptor forgets_newest_node;
constinit const EngineDescriptor forgets_newest_node{
    .name = "forgets_newest_node",
    .summary = "Wrong on purpose: never looks at the node added last.",
    .source = "a loop that ends one too early",
    .create = make_point_driven_engine<FaultyScan<Mistake>>,
};

}  // namespace phytobench::engines
