// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/component_graph/build_plant.hpp"
#include "core/tree/scene_object.hpp"

namespace phytobench {

/// One object per material, named "bark", "leaf", "plain", "bark-2", ... in their order, with a
/// texture of its colour: what the renderer and the exporters take. Takes the meshes over.
std::vector<SceneObject> scene_objects(BuiltPlant plant);

}  // namespace phytobench
