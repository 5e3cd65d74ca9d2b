// SPDX-License-Identifier: MIT
#include "benchmarks/broken/blocked_scan.hpp"

namespace phytobench::engines {

namespace {

struct Copying : Unbroken {
  static std::vector<SearchableNode> nodes_of(const std::vector<SearchableNode>& block) {
    return block;
  }
};

}  // namespace

extern const EngineDescriptor copies_nodes;
constinit const EngineDescriptor copies_nodes{
    .name = "copies_nodes",
    .summary = "Broken on purpose: copies the nodes of a block before it looks at them.",
    .source = "a return type without its &",
    .create = make_point_driven_engine<BlockedScan<Copying>>,
};

}  // namespace phytobench::engines
