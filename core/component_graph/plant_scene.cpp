// SPDX-License-Identifier: MIT
#include "core/component_graph/plant_scene.hpp"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/tree/textures.hpp"

namespace phytobench {

namespace {

constexpr std::array<std::string_view, 3> surface_words{"bark", "leaf", "plain"};

std::string texture_of(const Material& material) {
  if (material.surface == Surface::bark) return to_png(bark_texture(material.colour));
  constexpr int edge = 4;  // pixels of one colour
  return to_png(Image(edge, edge, to_pixel(material.colour)));
}

}  // namespace

std::vector<SceneObject> scene_objects(BuiltPlant plant) {
  std::vector<SceneObject> objects;
  std::array<int, surface_words.size()> used{};
  for (MeshPart& part : plant.parts) {
    const auto surface = static_cast<std::size_t>(part.material.surface);
    const std::string word(surface_words[surface]);
    SceneObject object;
    object.name = ++used[surface] == 1 ? word : fmt::format("{}-{}", word, used[surface]);
    object.material = object.name;
    object.mesh = std::move(part.mesh);
    object.texture_png = texture_of(part.material);
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace phytobench
