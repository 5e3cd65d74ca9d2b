// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/tree/scene_object.hpp"

namespace phytobench {

/// The bytes of a binary PLY file, little end first: all objects as one mesh with positions and
/// normals in single precision and a colour per vertex, the mean of its object's texture. Throws
/// InputError if its vertices are more than 32 bits can number.
std::string to_ply(const std::vector<SceneObject>& objects);

}  // namespace phytobench
