// SPDX-License-Identifier: MIT
#pragma once

#include "core/picture/image.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

enum class Surface {
  bark,   ///< streaks along v; v is the length along the branch, u goes once around it
  leaf,   ///< one colour; both sides are meshed
  plain,  ///< one colour
};

struct Material {
  Surface surface = Surface::bark;
  Colour colour;
  friend bool operator==(const Material&, const Material&) = default;
};

/// Triangles of one material.
struct MeshPart {
  Material material;
  TriangleMesh mesh;
};

}  // namespace phytobench
