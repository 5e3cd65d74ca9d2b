// SPDX-License-Identifier: MIT
#include "cli/plant_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/picture/render.hpp"
#include "core/tree/gltf_export.hpp"
#include "core/tree/obj_export.hpp"
#include "core/tree/ply_export.hpp"

namespace phytobench::cli {

namespace fs = std::filesystem;

PlantView view_of(const CameraOptions& camera, int threads) {
  PlantView view;
  view.azimuth_deg = camera.azimuth_deg.value_or(view.azimuth_deg);
  view.elevation_deg = camera.elevation_deg.value_or(view.elevation_deg);
  view.distance = camera.distance.value_or(view.distance);
  view.height = camera.picture_height.value_or(view.height);
  view.threads = threads;
  return view;
}

void refuse_odd_view(const PlantView& view) {
  const std::pair<const char*, double> numbers[] = {{"--azimuth", view.azimuth_deg},
                                                    {"--elevation", view.elevation_deg},
                                                    {"--distance", view.distance}};
  for (const auto& [option, number] : numbers)
    if (!std::isfinite(number))
      throw InputError(fmt::format("{} {}: give a finite number", option, number));
}

void refuse_idle_camera(const CameraOptions& camera, CameraUse use, const std::string& option) {
  const auto refuse = [&](const char* idle, const char* pictures) {
    throw InputError(
        fmt::format("{0} goes with {1} only; name one, as in {2} plant.png, or leave {0} out", idle,
                    pictures, option));
  };
  if (use == CameraUse::none && camera.azimuth_deg) refuse("--azimuth", "a picture of the plant");
  if (use == CameraUse::none && camera.elevation_deg)
    refuse("--elevation", "a picture of the plant");
  if (use != CameraUse::rendered && camera.distance) refuse("--distance", "a .png picture");
  if (use != CameraUse::rendered && camera.picture_height)
    refuse("--picture-height", "a .png picture");
}

void refuse_idle_split(bool split, const std::vector<std::string>& files) {
  if (split && std::none_of(files.begin(), files.end(), is_model))
    throw InputError(
        "--split goes with models only; name one, as in --out plant.obj, or leave --split out");
}

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_model(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".obj" || extension == ".glb" || extension == ".ply";
}

void refuse_other_models(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (!is_model(file)) throw InputError("--out " + file + " must end in .ply, .obj or .glb");
}

void refuse_without_renderer(const std::string& picture, const std::string& instead) {
  if (!can_render())
    throw EnvironmentError("--picture " + picture +
                           " needs Embree; install libembree-dev and build again, or " + instead);
}

std::string plant_picture(const std::vector<SceneObject>& objects, const BoundingBox& box,
                          const PlantView& view) {
  constexpr double aspect = 0.8;
  RenderOptions options{.height = view.height, .threads = view.threads};
  options.width = std::max(1, static_cast<int>(aspect * view.height));
  options.progress = [](double share) {
    show_progress(fmt::format("picture: {:.0f} %", 100.0 * share));
    return !is_interrupted();
  };
  Camera camera{.azimuth_deg = view.azimuth_deg, .elevation_deg = view.elevation_deg};
  camera = fitted(camera, box, aspect);
  if (view.distance > 0.0) camera.distance = view.distance;
  return to_png(render(objects, camera, options));
}

std::vector<FileContent> plant_models(const std::vector<SceneObject>& objects,
                                      const std::vector<std::string>& names) {
  std::vector<FileContent> files;
  for (const std::string& name : names) {
    show_progress("packing " + name);
    if (extension_of(name) == ".obj")
      for (FileContent& part : to_obj(objects, name)) files.push_back(std::move(part));
    else
      files.push_back({name, extension_of(name) == ".ply" ? to_ply(objects) : to_glb(objects)});
    if (is_interrupted()) throw Interrupted("nothing was written");
  }
  return files;
}

}  // namespace phytobench::cli
