// SPDX-License-Identifier: MIT
#include "core/tree/scene_object.hpp"

#include <fmt/format.h>

#include "core/contract/text_file.hpp"
#include "core/tree/textures.hpp"

namespace phytobench {

namespace {

/// The bytes of the user's PNG, checked, or of the one that is made.
template <class Make>
std::string texture_bytes(const std::string& file, const Make& make) {
  if (file.empty()) return to_png(make());
  std::string bytes = read_text_file(file);
  parse_png(bytes, file);
  return bytes;
}

}  // namespace

std::vector<SceneObject> scene_objects(Plant plant, const PlantParameters& parameters) {
  std::vector<SceneObject> objects;
  objects.push_back({"bark", "bark", std::move(plant.branches.mesh),
                     texture_bytes(parameters.bark_texture,
                                   [&] { return bark_texture(parameters.bark_colour); })});
  if (plant.leaves.empty()) return objects;
  objects.push_back(
      {"leaves", "leaves", std::move(plant.leaf_mesh),
       texture_bytes(
           parameters.leaf_texture,
           [&] { return leaf_particle_texture(parameters.leaf_colour, parameters.leaves.seed); }),
       true});
  return objects;
}

std::vector<SceneObject> split_objects(std::vector<SceneObject> objects,
                                       std::size_t most_vertices) {
  std::vector<SceneObject> parts;
  for (SceneObject& object : objects) {
    if (object.mesh.vertex_count() <= most_vertices) {
      parts.push_back(std::move(object));
      continue;
    }
    std::size_t number = 0;
    for (TriangleMesh& part : split(object.mesh, most_vertices)) {
      const std::string name =
          ++number == 1 ? object.name : fmt::format("{}-{}", object.name, number);
      parts.push_back(
          {name, object.material, std::move(part), object.texture_png, object.has_transparency});
    }
  }
  return parts;
}

BoundingBox box_of(const std::vector<SceneObject>& objects) {
  BoundingBox box;
  for (const SceneObject& object : objects)
    for (const Vector3& p : object.mesh.positions) box.extend(p);
  return box;
}

}  // namespace phytobench
