// SPDX-License-Identifier: MIT
#include "core/nearest_node/kill_scan.hpp"

namespace phytobench {

bool is_reached_by_any(const Vector3& point, std::span<const SearchableNode> killers,
                       double squared_reach) {
  bool reached = false;
  for (const SearchableNode& killer : killers)
    reached |= squared_distance(point, killer.position) <= squared_reach;
  return reached;
}

}  // namespace phytobench
