// SPDX-License-Identifier: MIT
// The thesis' figures, rendered from the same plants that the appendix' counts come from.
#include "core/picture/render.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr int width = 320, height = 400;  // of pictures that a report can hold
constexpr int full_scale = 4, full_samples = 2, full_quality = 90;

/// The picture for reports, and, as it takes seven times the work, the full-size one in full runs.
void draw_plant(ExperimentContext& context, const TreeParameters& parameters,
                const std::string& name) {
  const int threads = context.untimed_threads();
  const std::vector<SceneObject> objects = scene_objects(
      make_plant(grow_thesis_tree(parameters, threads), parameters.plant), parameters.plant);
  const Camera camera = fitted({}, box_of(objects), static_cast<double>(width) / height);
  context.artifact(
      name + ".jpg",
      to_jpeg(render(objects, camera, {.width = width, .height = height, .threads = threads})));
  if (context.tier() != Tier::full) return;
  const Image full = render(objects, camera,
                            {.width = full_scale * width,
                             .height = full_scale * height,
                             .samples = full_samples,
                             .threads = threads});
  context.artifact(name + ".full.jpg", to_jpeg(full, full_quality));
}

void run(ExperimentContext& context) {
  context.record("can_render", std::int64_t{can_render()});
  if (!can_render()) return;
  std::int64_t rendered = 0;
  const auto draw = [&](const std::string& figure, const std::string& label) {
    context.progress("picture of " + figure);
    draw_plant(context, thesis_tree(figure), figure + label);
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
    .seconds = {8, 8, 70},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
