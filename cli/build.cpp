// SPDX-License-Identifier: MIT
// phytobench build: a graph of components in, instances counted and checked, a plant out.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cli/build_findings.hpp"
#include "cli/build_moments.hpp"
#include "cli/commands.hpp"
#include "cli/component_list.hpp"
#include "cli/output_files.hpp"
#include "cli/plant_files.hpp"
#include "cli/terminal.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/instance_tree_text.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* options_of_tree = "--tree prints the i-tree alone; leave out ";

void check_tree_options(const PlantBuildOptions& options) {
  if (options.tree != "list" && options.tree != "dot")
    throw InputError("--tree=" + options.tree + ": give list or dot");
  if (options.json) throw InputError(std::string(options_of_tree) + "--json");
  if (!options.out.empty()) throw InputError(std::string(options_of_tree) + "--out");
  if (!options.picture.empty()) throw InputError(std::string(options_of_tree) + "--picture");
  if (options.resolution) throw InputError(std::string(options_of_tree) + "--resolution");
}

void check_options(const PlantBuildOptions& options) {
  if (!options.preset.empty() && !options.graph.empty())
    throw InputError("give a file of components or --preset, not both");
  if (options.preset.empty() && options.graph.empty())
    throw InputError(
        "build needs a file of components or a --preset; phytobench build --example list names "
        "components to start from, phytobench list graphs lists the presets");
  if (!options.tree.empty()) check_tree_options(options);
  if (!std::isfinite(options.resolution.value_or(1.0)))  // the command line lets "nan" pass
    throw InputError(fmt::format("--resolution {}: give a number", *options.resolution));
  refuse_odd_view(view_of(options, options.threads));
  refuse_other_models(options.out);
  const bool is_shown = !options.picture.empty();
  refuse_idle_camera(options, is_shown ? CameraUse::rendered : CameraUse::none, "--picture");
  refuse_idle_split(options.split, options.out);
  if (!is_shown) return;
  if (extension_of(options.picture) != ".png")
    throw InputError("--picture " + options.picture + " must end in .png");
  refuse_without_renderer(options.picture, "leave --picture out");
}

struct MomentFiles {
  std::vector<std::string> models;
  std::string picture;
};

/// Throws InputError where the files of two moments would have one name.
MomentFiles files_of(const PlantBuildOptions& options, std::size_t moment, std::size_t moments) {
  MomentFiles files{.models = options.out, .picture = options.picture};
  if (moments == 1) return files;
  for (std::string& name : files.models) name = frame_name(name, moment, "--out");
  if (!files.picture.empty()) files.picture = frame_name(files.picture, moment, "--picture");
  return files;
}

void refuse_frame_numbers(const PlantBuildOptions& options) {
  std::vector<std::string> names = options.out;
  names.push_back(options.picture);
  for (const std::string& name : names)
    if (has_frame_number(name))
      throw InputError(name + ": is a name for several frames; give --time FIRST:LAST:FRAMES");
}

/// Before minutes are spent on them.
void refuse_wrong_files(const PlantBuildOptions& options, const fs::path& graph_file,
                        std::size_t moments) {
  if (moments == 1) refuse_frame_numbers(options);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < moments; ++i) {
    MomentFiles files = files_of(options, i, moments);
    names.insert(names.end(), files.models.begin(), files.models.end());
    names.push_back(files.picture);
  }
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!name.empty() && fs::equivalent(name, graph_file, ignored))
      throw InputError(name + ": would overwrite the file of components; name another");
  }
  refuse_unwritable_files(names);
}

class PlantBuild {
 public:
  PlantBuild(const PlantBuildOptions& options, ComponentGraph graph, std::vector<double> moments)
      : options_(options), graph_(std::move(graph)), moments_(std::move(moments)) {}

  const ComponentGraph& graph() const { return graph_; }

  std::vector<BuildFindings> run() try {
    // The camera of an animation stands still: it must see every moment.
    if (is_animation() && !options_.picture.empty())
      for (std::size_t i = 0; i < moments_.size(); ++i) extend_box(at(i).first);
    std::vector<BuildFindings> frames;
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      auto [findings, objects] = at(i);
      if (!is_animation()) extend_box(findings);
      write(findings, objects, files_of(options_, i, moments_.size()));
      frames.push_back(std::move(findings));
    }
    return frames;
  } catch (const Interrupted&) {
    throw Interrupted(is_animation() ? "frames that were finished are kept" : "nothing is written");
  }

 private:
  bool is_animation() const { return moments_.size() > 1; }

  std::pair<BuildFindings, std::vector<SceneObject>> at(std::size_t moment) {
    graph_.time = moments_[moment];
    BuildFindings findings = counted_instances(graph_);
    phytobench::BuildOptions build_options;
    build_options.resolution = options_.resolution.value_or(build_options.resolution);
    build_options.progress = [&](double share) {
      show_progress(fmt::format("{}building: {:.0f} %", prefix_of(moment), 100.0 * share));
      return !is_interrupted();
    };
    if (is_interrupted()) throw Interrupted();
    BuiltPlant plant = build_plant(graph_, build_options);
    if (plant.triangle_count == 0 && writes_something())
      throw InputError(
          fmt::format("the plant has no triangles at time {}: no component in it has "
                      "a shape; add one, or leave out --out and --picture",
                      graph_.time));
    std::vector<SceneObject> objects = add_plant(findings, std::move(plant));
    return {std::move(findings), std::move(objects)};
  }

  bool writes_something() const { return !options_.out.empty() || !options_.picture.empty(); }

  std::string prefix_of(std::size_t moment) const {
    return is_animation() ? fmt::format("frame {} of {}, ", moment + 1, moments_.size()) : "";
  }

  void extend_box(const BuildFindings& findings) {
    if (findings.box.empty()) return;
    box_.extend(findings.box.low());
    box_.extend(findings.box.high());
  }

  void write(BuildFindings& findings, std::vector<SceneObject>& objects,
             const MomentFiles& names) const {
    std::vector<FileContent> files;
    if (!names.picture.empty())
      files.push_back(
          {names.picture, plant_picture(objects, box_, view_of(options_, options_.threads))});
    if (options_.split) objects = split_objects(std::move(objects));
    for (FileContent& file : plant_models(objects, names.models)) files.push_back(std::move(file));
    write_new_files(files);
    for (const FileContent& file : files) findings.files.push_back(file.file.string());
  }

  const PlantBuildOptions& options_;
  ComponentGraph graph_;
  std::vector<double> moments_;
  BoundingBox box_;  ///< that the camera sees
};

std::string tree_text(const ComponentGraph& graph, const std::string& format) {
  constexpr std::uint64_t most_shown = 10'000;
  const std::uint64_t count = count_instances(graph);
  if (count > most_shown)
    throw InputError(fmt::format(
        "the i-tree has {}{} instances, and --tree shows {} at most; lower most_recursions or the "
        "numbers of children and branches, or leave --tree out: build counts larger ones",
        count > InstanceLimits{}.most_instances ? "more than " : "",
        std::min(count, InstanceLimits{}.most_instances), most_shown));
  const InstanceTree tree = make_instance_tree(graph);
  return format == "dot" ? instance_tree_dot(graph, tree) : instance_tree_list(graph, tree);
}

}  // namespace

int build(const PlantBuildOptions& given) {
  if (!given.example.empty()) {
    print(component_example(given.example));
    return 0;
  }
  PlantBuildOptions options = given;
  check_options(options);
  if (!options.preset.empty()) options.graph = graph_preset_file(options.preset).string();
  ComponentGraph graph = read_component_graph(options.graph);
  if (options.seed) graph.seed = *options.seed;
  const std::vector<double> moments =
      options.time.empty() ? std::vector<double>{graph.time} : moments_from(options.time);
  if (!options.tree.empty()) {
    if (moments.size() > 1) throw InputError("--tree shows one moment; give --time one time");
    graph.time = moments.front();
    print(tree_text(graph, options.tree));
    return 0;
  }
  refuse_wrong_files(options, options.graph, moments.size());
  keep_freed_memory();
  catch_interrupts();  // from here on there are instances to stop between
  PlantBuild plant(options, std::move(graph), moments);
  const std::vector<BuildFindings> frames = plant.run();
  print(options.json ? build_json(plant.graph(), frames, options)
                     : build_text(plant.graph(), frames, options));
  return 0;
}

}  // namespace phytobench::cli
