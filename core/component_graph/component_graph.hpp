// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/component_graph/link_kind.hpp"
#include "core/component_graph/prototype.hpp"

namespace phytobench {

/// An edge of the p-graph; `from` and `to` are positions in ComponentGraph::prototypes.
struct ComponentLink {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  LinkKind kind = LinkKind::child;
};

/// The p-graph of [Lintermann1997] sec. 3.1: what a plant is made from, and by which rules.
struct ComponentGraph {
  std::vector<Prototype> prototypes;
  std::vector<ComponentLink> links;  ///< instances are made in this order, leaf links last
  /// Position of the prototype that hangs on the camera, where every plant begins. The camera
  /// itself is no instance.
  std::uint32_t root = 0;
  std::uint64_t seed = 0;  ///< of random() in the functions of parameters
  double time = 0.0;       ///< of key frames
};

}  // namespace phytobench
