// SPDX-License-Identifier: MIT
// What every command that makes a plant writes of it: models and pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "core/contract/text_file.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/tree/scene_object.hpp"

namespace phytobench::cli {

/// From where a picture shows a plant, and how.
struct PlantView {
  double azimuth_deg = 90.0;   ///< 0 looks from +x, 90 from +z
  double elevation_deg = 8.0;  ///< [-90, 90]
  double distance = 0.0;       ///< of the camera; 0: the whole box fits
  int height = 800;            ///< pixels
  int threads = 1;             ///< never change the picture
};

/// What the user asks for.
PlantView view_of(const CameraOptions& camera, int threads);

/// InputError for angles and a distance that are no numbers: the command line lets "nan" pass.
void refuse_odd_view(const PlantView& view);

/// What comes of the camera: nothing, a drawing of lines seen from its side, or a rendered picture.
enum class CameraUse { none, drawn, rendered };

/// InputError for an option of the camera that changes nothing. `option` names pictures: "--out".
void refuse_idle_camera(const CameraOptions& camera, CameraUse use, const std::string& option);

/// InputError for --split where none of the files is a model.
void refuse_idle_split(bool split, const std::vector<std::string>& files);

/// In small letters: ".png".
std::string extension_of(const std::filesystem::path& file);

/// Whether the name ends in .obj, .glb or .ply.
bool is_model(const std::string& file);

/// InputError for a model (`--out`) that ends in none of these.
void refuse_other_models(const std::vector<std::string>& files);

/// EnvironmentError if this build cannot make PNG pictures; `instead` says what else to do.
void refuse_without_renderer(const std::string& picture, const std::string& instead);

/// The bytes of a PNG file. The camera looks at the middle of `box`. Shows progress; throws
/// Interrupted.
std::string plant_picture(const std::vector<SceneObject>& objects, const BoundingBox& box,
                          const PlantView& view);

/// All files of the models. Shows progress; throws Interrupted.
std::vector<FileContent> plant_models(const std::vector<SceneObject>& objects,
                                      const std::vector<std::string>& files);

}  // namespace phytobench::cli
