// SPDX-License-Identifier: MIT
// What `derive` writes of a drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/plant_files.hpp"
#include "core/contract/text_file.hpp"
#include "core/lsystem/drawing.hpp"

namespace phytobench::cli {

/// InputError for a name that ends in no format of drawings, EnvironmentError for a .png that this
/// build cannot make.
void refuse_other_drawings(const std::vector<std::string>& names);

/// The most that one of these files makes of the camera.
CameraUse camera_use(const std::vector<std::string>& names);

/// All files of options.out. `tree` is that of the word, if it is one. InputError for a drawing
/// that is empty or too large. Shows progress; throws Interrupted.
std::vector<FileContent> drawing_files(const LSystem& system, const Word& word,
                                       const std::optional<TurtleTree>& tree,
                                       const LSystemDeriveOptions& options);

}  // namespace phytobench::cli
