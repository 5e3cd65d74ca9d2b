// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/component_graph/component_graph.hpp"
#include "core/component_graph/instance_tree.hpp"
#include "core/component_graph/material.hpp"

namespace phytobench {

struct BuildOptions {
  /// Detail of meshes, (0, 100]: every number of corners and pieces is multiplied by it.
  double resolution = 1.0;
  InstanceLimits limits;
  /// A plant with more is refused while it is built. About 150 bytes each.
  std::uint64_t most_triangles = 20'000'000;
  /// Called now and then with the share that is done; returning false stops.
  std::function<bool(double)> progress = {};
};

struct BuiltPlant {
  /// One per material, in the order of their first triangles.
  std::vector<MeshPart> parts;
  std::vector<std::uint64_t> instances;  ///< per prototype
  std::uint64_t instance_count = 0;      ///< of all; the camera is none
  std::uint64_t triangle_count = 0;
};

/// Walks the i-tree depth-first and lets every instance make its triangles ([Lintermann1997] sec.
/// 3.2). The root stands at the origin and grows along y. Throws InputError as
/// make_instance_tree(), and naming the component that makes coordinates which are not finite or
/// beyond 1e15; Interrupted if progress says so.
BuiltPlant build_plant(const ComponentGraph& graph, const BuildOptions& options = {});

}  // namespace phytobench
