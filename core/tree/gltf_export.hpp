// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/tree/scene_object.hpp"

namespace phytobench {

/// The bytes of a binary glTF 2.0 file (.glb): every object a mesh with positions, normals and
/// texture points in single precision, textures inside, y up, one length unit of the plant as one
/// meter. 16-bit indices where they reach. Transparent materials are cut at one half. Throws
/// InputError if it would exceed the 4 GiB that the format can hold.
std::string to_glb(const std::vector<SceneObject>& objects);

}  // namespace phytobench
