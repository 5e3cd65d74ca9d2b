// SPDX-License-Identifier: MIT
// Single components with settings by name, and what must hold of their meshes, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "core/component_graph/component_registry.hpp"
#include "core/component_graph/prototype.hpp"
#include "core/tree/mesh_measures.hpp"

namespace phytobench::component_fixture {

inline double degrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

/// Between two directions, without the loss near 0 and 180 of an arc cosine.
inline double angle_deg(const Vector3& a, const Vector3& b) {
  return degrees(std::atan2(norm(cross(a, b)), dot(a, b)));
}

class Tried {
 public:
  explicit Tried(std::string_view kind)
      : prototype_(make_prototype("it", component_kind_named(kind))) {}

  Tried& set(std::string_view key, double value) { return set_range(key, value, value); }
  Tried& set_range(std::string_view key, double first, double last) {
    ParameterRange range = ParameterRange::of(0.0);
    range.frames[0].value = {first, last};
    range.random_stream = position(key);
    prototype_.settings[position(key)] = range;
    return *this;
  }
  Tried& set_word(std::string_view key, std::string_view word) {
    const auto words = std::get<WordChoice>(prototype_.kind->keys[position(key)].kind).words;
    prototype_.settings[position(key)] =
        static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
    return *this;
  }
  Tried& set_list(std::string_view key, std::vector<double> numbers) {
    std::get<GivenNumbers>(prototype_.settings[position(key)]).numbers = std::move(numbers);
    return *this;
  }

  std::vector<Frame> frames(LinkKind link = LinkKind::child, std::size_t n = 1) const {
    std::vector<Frame> frames(n);
    prototype_.kind->place_children({values(), frame, context}, link, frames);
    return frames;
  }
  Frame child() const { return frames()[0]; }
  std::vector<MeshPart> parts() const {
    std::vector<MeshPart> parts;
    prototype_.kind->make_geometry({values(), frame, context}, parts);
    return parts;
  }
  /// Of a component with one part.
  TriangleMesh mesh() const { return parts().at(0).mesh; }
  BuildContext changed_context() const {
    BuildContext changed = context;
    prototype_.kind->change_context({values(), frame, context}, changed);
    return changed;
  }
  std::uint64_t children() const { return prototype_.kind->child_count(values()); }
  std::uint64_t branches() const { return prototype_.kind->branch_count(values()); }

  Frame frame;
  BuildContext context;
  InstancePlace place;

 private:
  ComponentValues values() const { return {prototype_.kind->keys, prototype_.settings, place}; }
  std::size_t position(std::string_view key) const {
    std::size_t i = 0;
    while (prototype_.kind->keys[i].name != key) ++i;  // a wrong name ends in a failed test
    return i;
  }

  Prototype prototype_;
};

/// Normals look to the side that their triangles look to.
inline bool normals_fit(const TriangleMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Vector3& a = mesh.positions[t[0]];
    const Vector3 across = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t i) { return dot(across, mesh.normals[i]) > 0.0; });
  });
}

}  // namespace phytobench::component_fixture
