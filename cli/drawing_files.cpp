// SPDX-License-Identifier: MIT
#include "cli/drawing_files.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "cli/plant_files.hpp"
#include "cli/terminal.hpp"
#include "core/contract/counted_noun.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_plant.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/lsystem/turtle_commands.hpp"
#include "core/picture/render.hpp"

namespace phytobench::cli {

namespace {

bool is_picture(const std::string& name) {
  return extension_of(name) == ".png";
}

bool needs_mesh(const std::string& name) {
  return is_model(name) || is_picture(name);
}

/// Before memory is asked for: a segment becomes a kilobyte of mesh.
void refuse_large_drawing(const LSystem& system, const Word& word,
                          const std::vector<std::string>& names) {
  constexpr std::size_t most_segments = 1'000'000;
  const std::size_t segments = count_drawing_modules(turtle_commands(system), word);
  for (const std::string& name : names)
    if (segments > most_segments && extension_of(name) != ".svg")
      throw InputError(fmt::format(
          "--out {}: a drawing of {} segments is too large (at most {}, it would not fit into "
          "memory); take fewer --steps",
          name, segments, most_segments));
}

DrawingPlantOptions plant_options(const LSystem& system) {
  DrawingPlantOptions options;
  options.colours = system.turtle.colours;
  return options;
}

std::string segment_table(const Drawing& drawing) {
  std::string csv = "from_x,from_y,from_z,to_x,to_y,to_z,width,colour\n";
  for (const TurtleSegment& s : drawing.segments)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{}\n", s.from.x, s.from.y,
                   s.from.z, s.to.x, s.to.y, s.to.z, s.width, s.colour);
  return csv;
}

/// A table of no segments would look like a drawing of nothing.
void refuse_empty_table(const LSystem& system, const Drawing& drawing,
                        const std::vector<std::string>& names) {
  if (!drawing.segments.empty()) return;
  for (const std::string& name : names)
    if (extension_of(name) == ".csv")
      throw InputError(
          fmt::format("--out {}: {} draws polygons alone at step {}, and the table has segments "
                      "alone; name a model or picture instead",
                      name, system.source, system.steps));
}

std::string svg_picture(const LSystem& system, const Drawing& drawing,
                        const LSystemDeriveOptions& options) {
  DrawingSvgOptions svg;
  svg.colours = system.turtle.colours;
  const PlantView view = view_of(options, options.threads);
  svg.azimuth_deg = view.azimuth_deg;
  svg.elevation_deg = view.elevation_deg;
  const std::string name = options.preset.empty() ? options.system : "preset " + options.preset;
  return drawing_svg(drawing,
                     fmt::format("{}, derived {}", name,
                                 counted_noun(static_cast<std::uint64_t>(system.steps), "time")),
                     svg);
}

/// Pictures have a ground, on which a drawing stands that would reach below it.
void lift_to_ground(std::vector<SceneObject>& objects) {
  const double low = box_of(objects).low().y;
  if (!(low < 0.0)) return;
  for (SceneObject& object : objects)
    for (Vector3& position : object.mesh.positions) position.y -= low;
}

std::vector<SceneObject> mesh_objects(const LSystem& system, const Drawing& drawing,
                                      const std::optional<TurtleTree>& tree) {
  const DrawingPlantOptions options = plant_options(system);
  show_progress("making meshes");
  return scene_objects(
      tree ? make_drawing_plant(*tree, drawing, options) : make_drawing_plant(drawing, options),
      options);
}

}  // namespace

void refuse_other_drawings(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (is_model(name) || extension_of(name) == ".svg" || extension_of(name) == ".csv") continue;
    if (!is_picture(name))
      throw InputError("--out " + name + " must end in .obj, .glb, .ply, .svg, .png or .csv");
    if (!can_render())
      throw EnvironmentError("--out " + name +
                             " needs Embree; install libembree-dev and build again, or ask for an "
                             ".svg picture");
  }
}

CameraUse camera_use(const std::vector<std::string>& names) {
  if (std::any_of(names.begin(), names.end(), is_picture)) return CameraUse::rendered;
  const auto is_svg = [](const std::string& name) { return extension_of(name) == ".svg"; };
  return std::any_of(names.begin(), names.end(), is_svg) ? CameraUse::drawn : CameraUse::none;
}

std::vector<FileContent> drawing_files(const LSystem& system, const Word& word,
                                       const std::optional<TurtleTree>& tree,
                                       const LSystemDeriveOptions& options) {
  if (options.out.empty()) return {};
  refuse_large_drawing(system, word, options.out);
  const Drawing drawing = draw(system, word);
  if (drawing.segments.empty() && drawing.polygons.empty())
    throw InputError(fmt::format(
        "{}: nothing is drawn at step {}, so that there is nothing to write; leave out --out",
        system.source, system.steps));
  refuse_empty_table(system, drawing, options.out);
  std::vector<SceneObject> objects;
  if (std::any_of(options.out.begin(), options.out.end(), needs_mesh))
    objects = mesh_objects(system, drawing, tree);
  std::vector<FileContent> files;
  std::vector<std::string> models;
  for (const std::string& name : options.out) {
    if (is_interrupted()) throw Interrupted("nothing is written");
    if (extension_of(name) == ".svg")
      files.push_back({name, svg_picture(system, drawing, options)});
    else if (extension_of(name) == ".csv")
      files.push_back({name, segment_table(drawing)});
    else if (is_model(name))
      models.push_back(name);
  }
  const std::vector<SceneObject> parts = options.split ? split_objects(objects) : objects;
  for (FileContent& file : plant_models(parts, models)) files.push_back(std::move(file));
  lift_to_ground(objects);
  for (const std::string& name : options.out)
    if (is_picture(name))
      files.push_back(
          {name, plant_picture(objects, box_of(objects), view_of(options, options.threads))});
  return files;
}

}  // namespace phytobench::cli
