// SPDX-License-Identifier: MIT
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/output_files.hpp"
#include "cli/plant_files.hpp"
#include "cli/terminal.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/counted_noun.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/skeleton_svg.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench::cli {

namespace {

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
  json["highest_y"] = shown(highest_y(tree));
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
  show_progress(fmt::format("iteration {}: {}, {}", pass.iteration + 1,
                            counted_noun(pass.searchable_nodes + pass.new_nodes, "node"),
                            counted_noun(pass.live_points, "live point")));
  return !is_interrupted();
}

/// Before seconds are spent on them.
void refuse_wrong_files(const GrowOptions& options) {
  std::vector<std::string> names = options.out;
  names.push_back(options.picture);
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!name.empty() && std::filesystem::equivalent(name, options.config, ignored))
      throw InputError(name + ": would overwrite the parameter file; name another");
  }
  refuse_unwritable_files(names);
}

/// Refuses what cannot work before anything has grown.
void check_options(const GrowOptions& options) {
  refuse_odd_view(view_of(options, options.threads));
  refuse_other_models(options.out);
  const std::string picture = extension_of(options.picture);
  refuse_idle_camera(options, picture == ".png" ? CameraUse::rendered : CameraUse::none,
                     "--picture");
  refuse_idle_split(options.split, options.out);
  if (!options.picture.empty() && picture != ".svg" && picture != ".png")
    throw InputError("--picture " + options.picture + " must end in .png or .svg");
  if (picture == ".png") refuse_without_renderer(options.picture, "ask for an .svg picture");
  refuse_wrong_files(options);
}

/// Everything that was asked for, made before anything is written.
std::vector<FileContent> make_files(const GrowOptions& options, const Skeleton& grown,
                                    std::vector<SceneObject> objects) {
  std::vector<FileContent> files;
  if (extension_of(options.picture) == ".svg")
    files.push_back({options.picture, skeleton_svg(grown, "Tree grown from " + options.config)});
  if (extension_of(options.picture) == ".png")
    files.push_back({options.picture,
                     plant_picture(objects, box_of(objects), view_of(options, options.threads))});
  if (options.split) objects = split_objects(std::move(objects));
  for (FileContent& file : plant_models(objects, options.out)) files.push_back(std::move(file));
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
  check_options(options);
  const TreeParameters parameters = read_tree_parameters(options.config);
  const LoopOptions loop = loop_options_named(options.option);
  const auto engine = engine_named(options.engine).create();
  const Seedling seedling = make_seedling(parameters);
  catch_interrupts();  // from here on there are iterations to stop between
  const GrowthResult result =
      grow_crown(seedling, *engine,
                 {.options = loop, .threads = options.threads, .observer = report_iteration});
  if (result.stop_reason == StopReason::interrupted) throw Interrupted("nothing was written");
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
  write_new_files(files);
  json["files"] = ordered_json::array();
  for (const FileContent& file : files) json["files"].push_back(file.file.string());
  print(options.json ? json.dump(2) + "\n" : plain_summary(json));
  return 0;
}

}  // namespace phytobench::cli
