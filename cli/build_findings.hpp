// SPDX-License-Identifier: MIT
// What `phytobench build` finds out about a plant at one moment, and how it is shown: as text and
// as a document of phytobench/build-1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "core/component_graph/build_plant.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/tree/scene_object.hpp"
#include "reference/component_counts.hpp"

namespace phytobench::cli {

struct MaterialFindings {
  std::string name;  ///< of its object in the files
  Material material;
  std::size_t triangles = 0;
  std::size_t vertices = 0;
};

struct BuildFindings {
  double time = 0.0;
  std::vector<std::uint64_t> instances;  ///< of each prototype
  PredictedCounts predicted;
  std::vector<std::uint64_t> link_instances;  ///< that each link has made
  std::uint64_t instance_count = 0;
  std::uint32_t levels = 0;  ///< of the i-tree; the root alone is one
  std::vector<MaterialFindings> materials;
  BoundingBox box;
  std::vector<std::string> files;  ///< that were written

  std::size_t triangle_count() const;
  std::size_t vertex_count() const;
};

/// Unfolds the graph and counts, without a triangle. ContractViolation, a bug of phytobench, if its
/// counts are not those predicted. InputError as make_instance_tree().
BuildFindings counted_instances(const ComponentGraph& graph);

/// Adds what the plant itself has, materials and box, and gives it as renderer and exporters take
/// it.
std::vector<SceneObject> add_plant(BuildFindings& findings, BuiltPlant plant);

/// `frames` holds one entry for each moment; the last one is described in full.
std::string build_json(const ComponentGraph& graph, const std::vector<BuildFindings>& frames,
                       const PlantBuildOptions& options);
std::string build_text(const ComponentGraph& graph, const std::vector<BuildFindings>& frames,
                       const PlantBuildOptions& options);

}  // namespace phytobench::cli
