// SPDX-License-Identifier: MIT
#include <limits>
#include <map>
#include <span>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/lsystem/drawing_plant.hpp"
#include "core/tree/textures.hpp"

namespace phytobench {

namespace {

constexpr std::uint32_t not_used = std::numeric_limits<std::uint32_t>::max();

/// Some triangles of a mesh, with the vertices that they use. `numbers` is of all vertices
/// `not_used`, and is so again afterwards.
TriangleMesh part_of(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                     std::vector<std::uint32_t>& numbers) {
  TriangleMesh part;
  std::vector<std::uint32_t> used;
  for (const std::uint32_t i : triangles) {
    Triangle renumbered = mesh.triangles[i];
    for (std::uint32_t& corner : renumbered) {
      std::uint32_t& number = numbers[corner];
      if (number == not_used) {
        number = static_cast<std::uint32_t>(used.size());
        used.push_back(corner);
      }
      corner = number;
    }
    part.triangles.push_back(renumbered);
  }
  for (const std::uint32_t vertex : used) {
    part.positions.push_back(mesh.positions[vertex]);
    part.normals.push_back(mesh.normals[vertex]);
    part.texture_points.push_back(mesh.texture_points[vertex]);
    numbers[vertex] = not_used;
  }
  return part;
}

/// A mesh for each colour that occurs.
std::map<std::size_t, TriangleMesh> parts_by_colour(const TriangleMesh& mesh,
                                                    std::span<const std::uint16_t> colours,
                                                    std::size_t colour_count) {
  PHYTOBENCH_EXPECT(colours.size() == mesh.triangle_count());
  std::map<std::size_t, std::vector<std::uint32_t>> triangles;
  for (std::size_t i = 0; i < colours.size(); ++i)
    triangles[colours[i] % colour_count].push_back(static_cast<std::uint32_t>(i));
  std::vector<std::uint32_t> numbers(mesh.vertex_count(), not_used);
  std::map<std::size_t, TriangleMesh> parts;
  for (const auto& [colour, of_colour] : triangles)
    parts[colour] = part_of(mesh, of_colour, numbers);
  return parts;
}

std::string plain_texture(const Colour& colour) {
  constexpr int edge = 4;  // pixels
  return to_png(Image(edge, edge, to_pixel(colour)));
}

}  // namespace

std::vector<SceneObject> scene_objects(DrawingPlant plant, const DrawingPlantOptions& options) {
  std::vector<SceneObject> objects;
  const std::size_t count = options.colours.size();
  if (count == 0) {
    if (!plant.branches.triangles.empty())
      objects.push_back(
          {"bark", "bark", std::move(plant.branches), to_png(bark_texture(options.bark_colour))});
    if (!plant.leaves.triangles.empty())
      objects.push_back(
          {"leaves", "leaves", std::move(plant.leaves), plain_texture(options.leaf_colour)});
    return objects;
  }
  for (auto& [colour, mesh] : parts_by_colour(plant.branches, plant.branch_colours, count)) {
    const std::string name = fmt::format("bark-c{}", colour);
    objects.push_back(
        {name, name, std::move(mesh), to_png(bark_texture(parse_colour(options.colours[colour])))});
  }
  for (auto& [colour, mesh] : parts_by_colour(plant.leaves, plant.leaf_colours, count)) {
    const std::string name = fmt::format("leaves-c{}", colour);
    objects.push_back(
        {name, name, std::move(mesh), plain_texture(parse_colour(options.colours[colour]))});
  }
  return objects;
}

}  // namespace phytobench
