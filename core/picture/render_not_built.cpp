// SPDX-License-Identifier: MIT
// Stands in for render_embree.cpp where Embree is not installed.
#include "core/contract/errors.hpp"
#include "core/picture/render.hpp"

namespace phytobench {

bool can_render() {
  return false;
}

std::string renderer_name() {
  return "not built: embree is missing";
}

Image render(const std::vector<SceneObject>&, const Camera&, const RenderOptions&) {
  throw EnvironmentError(
      "pictures of meshes are not built; install libembree-dev and build again, or "
      "ask for an .svg picture of the skeleton");
}

}  // namespace phytobench
