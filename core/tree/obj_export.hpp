// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/contract/text_file.hpp"
#include "core/tree/scene_object.hpp"

namespace phytobench {

/// The files of a Wavefront OBJ model: <file> itself, its materials in <stem>.mtl, and one PNG per
/// material, <stem>-<material>.png, all in one folder ([Brzoska2019] sec. 5.5.4). Coordinates are
/// rounded to single precision and written with the fewest digits that give it back.
std::vector<FileContent> to_obj(const std::vector<SceneObject>& objects,
                                const std::filesystem::path& file);

}  // namespace phytobench
