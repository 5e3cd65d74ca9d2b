// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/picture/camera.hpp"
#include "core/picture/image.hpp"
#include "core/tree/scene_object.hpp"

namespace phytobench {

struct RenderOptions {
  int width = 640;  ///< pixels, 1 to 16384
  int height = 800;
  int samples = 3;     ///< a pixel is the mean of samples x samples rays, 1 to 16
  int threads = 1;     ///< the picture is the same for any number
  bool ground = true;  ///< a plane at y = 0 that takes the shadow
  /// Called between bands of rows with the share that is done; returning false stops.
  std::function<bool(double)> progress = {};
};

/// Whether this build can render.
bool can_render();

/// What renders, with its version; or what is missing.
std::string renderer_name();

/// Traces the objects in the light of a sun of some width and of the sky: soft shadows, a ground,
/// transparent textures cut at one half. A pixel is a pure function of scene, camera and options.
/// Throws EnvironmentError if can_render() is false, Interrupted if progress says so.
Image render(const std::vector<SceneObject>& objects, const Camera& camera,
             const RenderOptions& options);

}  // namespace phytobench
