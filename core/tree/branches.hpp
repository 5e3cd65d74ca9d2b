// SPDX-License-Identifier: MIT
// What follows from a skeleton's branching alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// The children of every node, each list ascending.
class ChildLists {
 public:
  explicit ChildLists(const Skeleton& skeleton);

  std::span<const std::int32_t> of(std::int32_t node) const {
    const auto n = static_cast<std::size_t>(node);
    return {children_.data() + begins_[n], children_.data() + begins_[n + 1]};
  }

 private:
  std::vector<std::size_t> begins_;  // one more than nodes
  std::vector<std::int32_t> children_;
};

/// Tips at or above each node; a tip counts itself. The root alone is a tip.
std::vector<std::int32_t> tips_above(const Skeleton& skeleton);

/// Edges between the root and each node. The only reading of "order" under which the order 25 of
/// [Brzoska2019] fig. 43 means something (ambiguity A4).
std::vector<std::int32_t> node_depths(const Skeleton& skeleton);

/// Branch order of each node: 0 on the main axis from the root, one more on each side branch. At a
/// branching the axis goes on in the child with the greatest radius, of equal ones the first. Radii
/// per node.
std::vector<std::int32_t> branch_orders(const Skeleton& skeleton, std::span<const double> radii);

/// Radius of each node by the power-sum rule r^n = r1^n + ... + rk^n ([Brzoska2019] eq. 11 and 12;
/// n = 2 is the pipe model, n = 3 Murray's law). Every tip has radius tip_radius > 0; exponent > 0.
/// The rule makes a radius a function of the number of tips above, and so it is computed: no sum of
/// rounded powers.
std::vector<double> branch_radii(const Skeleton& skeleton, double tip_radius, double exponent);

}  // namespace phytobench
