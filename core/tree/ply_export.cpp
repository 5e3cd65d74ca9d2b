// SPDX-License-Identifier: MIT
#include "core/tree/ply_export.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/picture/image.hpp"

namespace phytobench {

namespace {

using Channels = std::array<std::uint8_t, 3>;

/// Of what can be seen of the texture.
Channels mean_colour(const SceneObject& object) {
  const Image texture = parse_png(object.texture_png, object.name);
  std::array<std::uint64_t, 3> sums{};
  std::uint64_t weights = 0;
  for (const Pixel& pixel : texture.pixels()) {
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += std::uint64_t{pixel[c]} * pixel[3];
    weights += pixel[3];
  }
  Channels mean{};
  for (std::size_t c = 0; weights > 0 && c < sums.size(); ++c)
    mean[c] = static_cast<std::uint8_t>((sums[c] + weights / 2) / weights);
  return mean;
}

void put(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
}

void put(std::string& bytes, const Vector3& v) {
  for (const double number : {v.x, v.y, v.z})
    put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(number)));
}

std::string header(std::size_t vertices, std::size_t triangles) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      vertices, triangles);
}

void put_vertices(std::string& bytes, const SceneObject& object) {
  const Channels colour = mean_colour(object);
  for (std::size_t i = 0; i < object.mesh.vertex_count(); ++i) {
    put(bytes, object.mesh.positions[i]);
    put(bytes, object.mesh.normals[i]);
    for (const std::uint8_t channel : colour) bytes += static_cast<char>(channel);
  }
}

void put_triangles(std::string& bytes, const TriangleMesh& mesh, std::uint32_t first_vertex) {
  for (const Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : triangle) put(bytes, first_vertex + corner);
  }
}

}  // namespace

std::string to_ply(const std::vector<SceneObject>& objects) {
  constexpr std::size_t vertex_bytes = 27, triangle_bytes = 13;
  std::size_t vertices = 0, triangles = 0;
  for (const SceneObject& object : objects) {
    vertices += object.mesh.vertex_count();
    triangles += object.mesh.triangle_count();
  }
  if (vertices > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format(
        "a PLY file cannot number {} vertices; make a smaller plant or coarser meshes", vertices));
  std::string bytes = header(vertices, triangles);
  bytes.reserve(bytes.size() + vertex_bytes * vertices + triangle_bytes * triangles);
  for (const SceneObject& object : objects) put_vertices(bytes, object);
  std::uint32_t first_vertex = 0;
  for (const SceneObject& object : objects) {
    put_triangles(bytes, object.mesh, first_vertex);
    first_vertex += static_cast<std::uint32_t>(object.mesh.vertex_count());
  }
  return bytes;
}

}  // namespace phytobench
