// SPDX-License-Identifier: MIT
// One component as a file would set it, what its kind makes of it, and counts of whole graphs.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/instance_tree.hpp"

namespace phytobench::experiments::lintermann1997 {

/// Of that kind, at the root, with keys as the lines of a file set them; others at their defaults.
class SingleComponent {
 public:
  explicit SingleComponent(std::string_view kind, std::string_view keys = "")
      : graph_(parse_component_graph(
            fmt::format("[graph]\nroot = \"it\"\n[component.it]\nkind = \"{}\"\n{}\n", kind, keys),
            "experiment")) {}

  std::vector<Frame> frames(LinkKind link, std::size_t n) const {
    std::vector<Frame> frames(n);
    const ComponentValues values = this->values();
    prototype().kind->place_children({values, frame, context}, link, frames);
    return frames;
  }
  std::vector<Frame> children(std::size_t n) const { return frames(LinkKind::child, n); }
  Frame child() const { return children(1)[0]; }
  TriangleMesh mesh() const {
    std::vector<MeshPart> parts;
    const ComponentValues values = this->values();
    prototype().kind->make_geometry({values, frame, context}, parts);
    return std::move(parts.at(0).mesh);
  }
  BuildContext changed_context() const {
    BuildContext changed = context;
    const ComponentValues values = this->values();
    prototype().kind->change_context({values, frame, context}, changed);
    return changed;
  }

  Frame frame;
  BuildContext context;

 private:
  const Prototype& prototype() const { return graph_.prototypes[0]; }
  ComponentValues values() const {
    return {prototype().kind->keys, prototype().settings, InstancePlace{}};
  }

  ComponentGraph graph_;
};

inline double degrees_of(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

/// Between two directions, without the loss of an arc cosine near 0 and 180.
inline double angle_deg(const Vector3& a, const Vector3& b) {
  return degrees_of(std::atan2(norm(cross(a, b)), dot(a, b)));
}

/// About y, 0 along z, counter-clockwise seen from +y; [0, 360).
inline double azimuth_deg(const Vector3& v) {
  const double azimuth = degrees_of(std::atan2(v.x, v.z));
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

/// The turn about y from one direction on to another, [0, 360).
inline double azimuth_step_deg(const Vector3& from, const Vector3& to) {
  const double step = azimuth_deg(to) - azimuth_deg(from);
  return step < 0.0 ? step + 360.0 : step;
}

inline ComponentGraph graph_of(std::string_view text) {
  return parse_component_graph(text, "experiment");
}

/// Instances of the prototypes, by their names.
inline std::map<std::string, std::int64_t> instances_by_name(const ComponentGraph& graph) {
  const auto made = instances_per_prototype(graph, make_instance_tree(graph));
  std::map<std::string, std::int64_t> instances;
  for (std::size_t i = 0; i < made.size(); ++i)
    instances[graph.prototypes[i].name] = static_cast<std::int64_t>(made[i]);
  return instances;
}

/// Of all vertices of a plant, part after part.
inline std::vector<Vector3> positions_of(const ComponentGraph& graph) {
  std::vector<Vector3> positions;
  for (const MeshPart& part : build_plant(graph).parts)
    positions.insert(positions.end(), part.mesh.positions.begin(), part.mesh.positions.end());
  return positions;
}

/// The greatest distance between vertices of the same number; another number of them counts as far.
inline double greatest_distance(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  if (a.size() != b.size()) return 1e9;
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::fmax(greatest, norm(a[i] - b[i]));
  return greatest;
}

}  // namespace phytobench::experiments::lintermann1997
