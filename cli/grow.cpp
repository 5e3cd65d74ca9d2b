// SPDX-License-Identifier: MIT
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/picture/render.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/gltf_export.hpp"
#include "core/tree/obj_export.hpp"
#include "core/tree/skeleton_svg.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json summary(const GrowOptions& options, const TreeParameters& parameters,
                     const Seedling& seedling, const GrowthResult& result) {
  const Skeleton& tree = result.skeleton;
  ordered_json json;
  json["schema"] = "phytobench/grow-2";
  json["config"] = options.config;
  json["seed"] = parameters.seed;
  json["random"] = name_of(parameters.random);
  json["engine"] = options.engine;
  json["option"] = options.option;
  json["attraction_points"] = seedling.attraction_points.size();
  // Not those at the end: option D leaves the last removal undone, the others do it.
  json["points_at_last_search"] = result.passes.back().live_points;
  json["iterations"] = result.passes.size();
  json["stop_reason"] = name_of(result.stop_reason);
  json["nodes"] = tree.node_count();
  json["edges"] = tree.edge_count();
  json["tips"] = tip_count(tree);
  json["edge_depth"] = edge_depth(tree);
  json["highest_y"] = highest_y(tree);
  json["tree_hash"] = tree_hash(tree);
  return json;
}

void add_plant(ordered_json& json, const Plant& plant) {
  json["leaves"] = plant.leaves.size();
  json["duplicated_rings"] = plant.branches.duplicated_rings;
  json["vertices"] = plant.vertex_count();
  json["triangles"] = plant.triangle_count();
  json["root_radius"] = plant.radii.front();
}

void add_work(ordered_json& json, const WorkCounters& work) {
  json["work"] = {{"search_evaluations", work.search_evaluations},
                  {"kill_evaluations", work.kill_evaluations},
                  {"queries", work.queries},
                  {"cells_visited", work.cells_visited},
                  {"index_updates", work.index_updates}};
}

std::string plain_summary(const ordered_json& json) {
  std::string text;
  for (const char* key :
       {"attraction_points", "points_at_last_search", "iterations", "stop_reason", "nodes", "edges",
        "tips", "edge_depth", "highest_y", "tree_hash", "leaves", "vertices", "triangles"})
    text += fmt::format("{:<22} {}\n", key,
                        json[key].is_string() ? json[key].get<std::string>() : json[key].dump());
  for (const ordered_json& file : json["files"])
    text += fmt::format("{:<22} {}\n", "wrote", file.get<std::string>());
  return text;
}

bool report_iteration(const PassStatistics& pass) {
  show_progress(fmt::format("iteration {}: {} nodes, {} live points", pass.iteration + 1,
                            pass.searchable_nodes + pass.new_nodes, pass.live_points));
  return !is_interrupted();
}

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// Refuses what cannot work before anything has grown.
void check_file_names(const GrowOptions& options) {
  for (const std::string& file : options.out)
    if (extension_of(file) != ".obj" && extension_of(file) != ".glb")
      throw InputError("--out " + file + " must end in .obj or .glb");
  const std::string picture = extension_of(options.picture);
  if (!options.picture.empty() && picture != ".svg" && picture != ".png")
    throw InputError("--picture " + options.picture + " must end in .png or .svg");
  if (picture == ".png" && !can_render())
    throw EnvironmentError(
        "--picture " + options.picture +
        " needs Embree; install libembree-dev and build again, or ask for an .svg picture");
  if (!options.picture.empty() && options.picture == options.config)
    throw InputError("--picture " + options.picture +
                     " would overwrite the parameter file; name another");
}

std::string rendered(const GrowOptions& options, const std::vector<SceneObject>& objects) {
  constexpr double aspect = 0.8;
  RenderOptions render_options{.height = options.picture_height, .threads = options.threads};
  render_options.width = std::max(1, static_cast<int>(aspect * options.picture_height));
  render_options.progress = [](double share) {
    show_progress(fmt::format("picture: {:.0f} %", 100.0 * share));
    return !is_interrupted();
  };
  Camera camera{.azimuth_deg = options.azimuth_deg, .elevation_deg = options.elevation_deg};
  camera = fitted(camera, box_of(objects), aspect);
  if (options.distance > 0.0) camera.distance = options.distance;
  return to_png(render(objects, camera, render_options));
}

/// Everything that was asked for, made before anything is written.
std::vector<FileContent> make_files(const GrowOptions& options, const Skeleton& grown,
                                    std::vector<SceneObject> objects) {
  std::vector<FileContent> files;
  if (extension_of(options.picture) == ".svg")
    files.push_back({options.picture, skeleton_svg(grown, "Tree grown from " + options.config)});
  if (extension_of(options.picture) == ".png")
    files.push_back({options.picture, rendered(options, objects)});
  if (options.split) objects = split_objects(std::move(objects));
  for (const std::string& file : options.out) {
    show_progress("packing " + file);
    if (extension_of(file) == ".obj")
      for (FileContent& part : to_obj(objects, file)) files.push_back(std::move(part));
    else
      files.push_back({file, to_glb(objects)});
    if (is_interrupted()) throw Interrupted();
  }
  return files;
}

}  // namespace

int grow(const GrowOptions& given) {
  if (given.example) {
    print(example_tree_file());
    return 0;
  }
  GrowOptions options = given;
  if (!options.preset.empty() && !options.config.empty())
    throw InputError("give a parameter file or --preset, not both");
  if (!options.preset.empty()) options.config = tree_preset_file(options.preset).string();
  if (options.config.empty())
    throw InputError(
        "grow needs a parameter file or a --preset; phytobench grow --example prints a file to "
        "start from, phytobench list presets lists the presets");
  check_file_names(options);
  const TreeParameters parameters = read_tree_parameters(options.config);
  const LoopOptions loop = loop_options_named(options.option);
  const auto engine = engine_named(options.engine).create();
  const Seedling seedling = make_seedling(parameters);
  catch_interrupts();  // from here on there are iterations to stop between
  const GrowthResult result =
      grow_crown(seedling, *engine,
                 {.options = loop, .threads = options.threads, .observer = report_iteration});
  if (result.stop_reason == StopReason::interrupted) throw Interrupted();
  if (result.skeleton.node_count() == seedling.skeleton.node_count())
    throw InputError(options.config + ": " +
                     (result.stop_reason == StopReason::no_child_allowed
                          ? std::string("growth cannot start: growth.most_children or "
                                        "growth.most_branch_depth forbids every child; raise "
                                        "them, or set stem.crown_ratio to 0")
                          : why_growth_cannot_start(seedling)));

  ordered_json json = summary(options, parameters, seedling, result);
  Plant plant = make_plant(result.skeleton, parameters.plant);
  add_plant(json, plant);
  add_work(json, result.work);
  const std::vector<FileContent> files =
      make_files(options, result.skeleton, scene_objects(std::move(plant), parameters.plant));
  write_files_atomically(files);
  json["files"] = ordered_json::array();
  for (const FileContent& file : files) json["files"].push_back(file.file.string());
  print(options.json ? json.dump(2) + "\n" : plain_summary(json));
  return 0;
}

}  // namespace phytobench::cli
