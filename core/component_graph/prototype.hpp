// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/component_graph/component.hpp"

namespace phytobench {

/// What instances are copied from: a node of the p-graph ([Lintermann1997] sec. 3.1).
struct Prototype {
  std::string name;
  const ComponentKind* kind = nullptr;
  /// One per key of the kind, in that order.
  std::vector<ComponentSetting> settings;
  /// How many of its instances may lie on one way from the root, >= 1. Absent: any number. (The
  /// paper gives every component a limit but names no default.) The limit belongs to the component
  /// and not to a loop, as the counter of sec. 3.1 does: all loops through it use it up together,
  /// and an inner one does not start anew in each turn of the outer one.
  std::optional<std::uint32_t> most_recursions;
};

/// A prototype with every key at its default.
Prototype make_prototype(std::string name, const ComponentKind& kind);

/// Whether two instances of it may differ in how many children or branches they make at one time.
bool multiplicity_varies(const Prototype& prototype);

}  // namespace phytobench
