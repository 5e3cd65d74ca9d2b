// SPDX-License-Identifier: MIT
// The thesis counts its parameters (sec. 7) without listing them. Here are those that its text
// names; each is changed alone, and what changes with it is seen on the plant.
#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/colonization/tree_parameters_file.hpp"
#include "core/tree/scene_object.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// A parameter of the thesis, and the line of a tree file that sets another value.
struct Control {
  std::string_view name;
  std::string_view line;
  std::string_view beside = "";  ///< lines without which the parameter does nothing
};

/// The start settings. Their density of points is kept: gnarliness would set its own.
constexpr std::string_view start_file = "cloud.density = 26.4\n";

constexpr std::string_view hanging = "pendulous.intensity = 0.4\n";

constexpr Control controls[] = {
    {"crown-width", "cloud.radii = [6.0, 7.0, 4.5]"},
    {"crown-height", "cloud.radii = [5.0, 8.0, 4.5]"},
    {"crown-depth", "cloud.radii = [5.0, 7.0, 5.5]"},
    {"cutoff-top", "cloud.cutoff_top = 0.2"},
    {"cutoff-bottom", "cloud.cutoff_bottom = 0.3"},
    {"iterations", "growth.iterations = 25"},
    {"density-begin", "growth.branch_density_begin = 0.3"},
    {"density-end", "growth.branch_density_end = 0.6"},
    {"gnarliness", "growth.gnarliness = 0.5"},
    {"crown-stem-ratio", "stem.crown_ratio = 0.5"},
    {"pendulous-intensity", "pendulous.intensity = 0.4"},
    {"pendulous-begin", "pendulous.first_order = 15", hanging},
    {"stem-length", "stem.length = 1.0"},
    {"stem-thickness", "branches.thickness = 0.7"},
    {"circle-resolution", "mesh.circle_resolution = 5"},
    {"leaf-density", "leaves.per_node = 0.3"},
    {"leaf-size", "leaves.size = 0.5"},
    {"leaf-type", "leaves.shape = \"square\""},
    {"leaf-colour", "colours.leaves = \"#b03020\""},
    {"bark-colour", "colours.bark = \"#d8d2c4\""},
};

/// All that a parameter may change.
struct Outcome {
  std::vector<Vector3> cloud;  ///< seen from the crown root
  std::vector<Vector3> crown;  ///< nodes of the finished plant, seen from the crown root
  std::vector<SceneObject> look;
};

TreeParameters parsed(std::string_view lines) {
  return parse_tree_parameters(std::string(start_file).append(lines), "parameter");
}

TreeOnStem grown(const TreeParameters& parameters, int threads) {
  return {.skeleton = grow_thesis_tree(parameters, threads),
          .crown_root = make_seedling(parameters).crown_root};
}

Outcome outcome_of(const TreeOnStem& tree, const TreeParameters& parameters) {
  Outcome outcome;
  const Seedling seedling = make_seedling(parameters);
  for (const Vector3& point : seedling.attraction_points)
    outcome.cloud.push_back(point - seedling.skeleton.position(seedling.crown_root));
  Plant plant = make_plant(tree.skeleton, parameters.plant);
  const auto& nodes = plant.skeleton.positions();
  for (auto i = static_cast<std::size_t>(tree.crown_root); i < nodes.size(); ++i)
    outcome.crown.push_back(nodes[i] - plant.skeleton.position(tree.crown_root));
  outcome.look = scene_objects(std::move(plant), parameters.plant);
  return outcome;
}

/// Up to what moving a crown does to the last digits.
bool same_places(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vector3& p, const Vector3& q) { return norm(p - q) < 1e-9; });
}

bool same_object(const SceneObject& a, const SceneObject& b) {
  return a.texture_png == b.texture_png && a.mesh.positions == b.mesh.positions &&
         a.mesh.triangles == b.mesh.triangles;
}

/// What a change does to the plant, in words.
std::string change_between(const Outcome& before, const Outcome& after) {
  const bool cloud = !same_places(before.cloud, after.cloud);
  const bool crown = !same_places(before.crown, after.crown);
  if (cloud) return crown ? "cloud and crown" : "cloud";
  if (crown) return "crown";
  const bool look = !std::equal(before.look.begin(), before.look.end(), after.look.begin(),
                                after.look.end(), same_object);
  return look ? "look" : "nothing";
}

/// A stem of another length is put below the same crown, as the thesis does (sec. 5.5.1).
std::string change_by(const Control& control, int threads) {
  const TreeParameters before = parsed(control.beside);
  const TreeParameters after = parsed(fmt::format("{}{}\n", control.beside, control.line));
  const TreeOnStem tree = grown(before, threads);
  const bool only_stem = control.line.starts_with("stem.length");
  return change_between(
      outcome_of(tree, before),
      outcome_of(only_stem ? regrow_stem(tree, after) : grown(after, threads), after));
}

void record_side_effects(ExperimentContext& context) {
  context.record("side-effects/stem-length-of-a-hanging-crown",
                 change_by({"", "stem.length = 1.0", hanging}, context.threads()));
  const auto points_of = [](std::string_view text) {
    return make_seedling(parse_tree_parameters(text, "parameter")).attraction_points.size();
  };
  context.record("side-effects/points-of-gnarliness-0.5",
                 static_cast<std::int64_t>(points_of("growth.gnarliness = 0.5\n")), "points");
  context.record("side-effects/points-of-gnarliness-0.8",
                 static_cast<std::int64_t>(points_of("growth.gnarliness = 0.8\n")), "points");
}

void run(ExperimentContext& context) {
  std::map<std::string, std::int64_t> counts;
  for (const Control& control : controls) {
    context.progress(fmt::format("changing {}", control.name));
    const std::string change = change_by(control, context.threads());
    context.record({.experiment = {},
                    .measurement = fmt::format("control/{}/changes", control.name),
                    .value = change,
                    .seed = parsed(control.beside).seed});
    ++counts[change];
  }
  const auto tried = static_cast<std::int64_t>(std::size(controls));
  context.record("controls/tried", tried, "parameters");
  context.record("controls/with-effect", tried - counts["nothing"], "parameters");
  context.record("controls/of-the-crown",
                 counts["cloud and crown"] + counts["crown"] + counts["cloud"], "parameters");
  context.record("controls/of-the-cloud", counts["cloud and crown"] + counts["cloud"],
                 "parameters");
  record_side_effects(context);
}

}  // namespace

extern const ExperimentDescriptor parameter_roles;
constinit const ExperimentDescriptor parameter_roles{
    .id = "brzoska2019/parameter-roles",
    .question =
        "Which of the parameters that the thesis names change the cloud, the crown, or "
        "only the look?",
    .source = "[Brzoska2019] sec. 7, 6.2",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
