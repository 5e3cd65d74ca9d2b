// SPDX-License-Identifier: MIT
// The contract of every kind of component ([Lintermann1997] sec. 4).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/component_graph/build_context.hpp"
#include "core/component_graph/component_key.hpp"
#include "core/component_graph/component_values.hpp"
#include "core/component_graph/frame.hpp"
#include "core/component_graph/link_kind.hpp"
#include "core/component_graph/material.hpp"

namespace phytobench {

/// One instance, as its kind sees it.
struct ComponentInput {
  const ComponentValues& values;
  const Frame& frame;  ///< of the instance in the world: it starts at the origin and grows along y
  const BuildContext& context;
};

/// One constant of this type per file in components/, one line in components.def. Every function is
/// pure: what it gives depends on nothing but its arguments.
struct ComponentKind {
  std::string_view name;     ///< that of its file
  std::string_view summary;  ///< one sentence
  std::string_view source;   ///< "[Lintermann1997] sec. 4"
  std::span<const ComponentKey> keys;
  /// A multiplier makes count() children for every child link, others one.
  bool is_multiplier = false;
  /// May have branch links: makes branch_count() of each.
  bool carries_branches = false;
  std::string_view missing_package = {};  ///< empty if built

  /// Children per child link of a multiplier; null for others.
  std::uint64_t (*child_count)(const ComponentValues&) = nullptr;
  /// Branches per branch link, 0 if it bears none; null unless carries_branches.
  std::uint64_t (*branch_count)(const ComponentValues&) = nullptr;

  /// Fills frames[i - 1] with where child i of n = frames.size() starts, in the instance's own
  /// frame: the identity is where the instance itself starts. Child and leaf links ask for children
  /// (one at the end of the component unless it multiplies), branch links for branches. Never null.
  void (*place_children)(const ComponentInput&, LinkKind link, std::span<Frame> frames) = nullptr;

  /// Appends the instance's triangles in the instance's own frame: the caller moves, turns and
  /// scales them, then bends them. Null: it has none.
  void (*make_geometry)(const ComponentInput&, std::vector<MeshPart>& parts) = nullptr;

  /// What it changes for all that hangs below it. Null: nothing.
  void (*change_context)(const ComponentInput&, BuildContext&) = nullptr;

  bool built() const { return place_children != nullptr; }
};

}  // namespace phytobench
