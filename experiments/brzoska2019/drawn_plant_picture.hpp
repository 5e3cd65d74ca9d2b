// SPDX-License-Identifier: MIT
// Pictures of plants whose lines are too many for a drawing that a report can hold.
#pragma once

#include <string>
#include <vector>

#include "core/lsystem/drawing_plant.hpp"
#include "core/picture/render.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

/// <name>.jpg, where this build can render. `view` is moved such that it shows all.
inline void add_plant_picture(ExperimentContext& context, const std::string& name,
                              DrawingPlant plant, const DrawingPlantOptions& options,
                              const Camera& view, bool ground) {
  if (!can_render()) return;
  constexpr int width = 420, height = 480;
  const std::vector<SceneObject> objects = scene_objects(std::move(plant), options);
  RenderOptions render_options;
  render_options.width = width;
  render_options.height = height;
  render_options.samples = 2;
  render_options.threads = context.untimed_threads();
  render_options.ground = ground;
  const Camera camera = fitted(view, box_of(objects), static_cast<double>(width) / height);
  context.artifact(name + ".jpg", to_jpeg(render(objects, camera, render_options)));
}

}  // namespace phytobench::experiments::brzoska2019
