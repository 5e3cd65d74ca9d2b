// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/picture/image.hpp"
#include "core/tree/plant.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// A mesh with a texture, as exporters and the renderer take it.
struct SceneObject {
  std::string name;      ///< unique among the objects of a scene
  std::string material;  ///< objects of the same material share texture and transparency
  TriangleMesh mesh;
  std::string texture_png;        ///< bytes of a PNG file
  bool has_transparency = false;  ///< texture parts with opacity below one half are not there
};

/// "bark" and "leaves"; a plant without leaves has no second object. Takes the plant's meshes over.
/// Reads the textures that the parameters name. Throws InputError if one cannot be read.
std::vector<SceneObject> scene_objects(Plant plant, const PlantParameters& parameters);

/// The same with every mesh cut into parts of at most `most_vertices`, named "bark", "bark-2", ...
std::vector<SceneObject> split_objects(std::vector<SceneObject> objects,
                                       std::size_t most_vertices = 65536);

/// The box around all of them.
BoundingBox box_of(const std::vector<SceneObject>& objects);

}  // namespace phytobench
