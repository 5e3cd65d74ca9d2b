// SPDX-License-Identifier: MIT
// The thesis' figures, rendered from the same plants that the appendix' counts come from.
#include "core/picture/render.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr int width = 360, height = 450;

std::string picture_of(const TreeParameters& parameters, int threads) {
  const std::vector<SceneObject> objects = scene_objects(
      make_plant(grow_thesis_tree(parameters, threads), parameters.plant), parameters.plant);
  const Camera camera = fitted({}, box_of(objects), static_cast<double>(width) / height);
  return to_jpeg(render(objects, camera, {.width = width, .height = height, .threads = threads}));
}

void run(ExperimentContext& context) {
  context.record("can_render", std::int64_t{can_render()});
  if (!can_render()) return;
  std::int64_t rendered = 0;
  const auto draw = [&](const std::string& figure, const std::string& label) {
    context.progress("picture of " + figure);
    context.artifact(figure + label + ".jpg", picture_of(thesis_tree(figure), context.threads()));
    ++rendered;
  };
  const TomlTable parameters = thesis_parameters();
  for (const std::string& figure : parameters.table("appendix").texts("rows")) draw(figure, "");
  for (const std::string& figure : parameters.table("pictures").texts("ours"))
    draw(figure, "-ours");
  context.record("rendered", rendered);
}

}  // namespace

extern const ExperimentDescriptor pictures;
constinit const ExperimentDescriptor pictures{
    .id = "brzoska2019/pictures",
    .question = "What do the plants of the thesis' figures look like, grown again?",
    .source = "[Brzoska2019] fig. 40-53",
    .seconds = {12, 12, 12},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
