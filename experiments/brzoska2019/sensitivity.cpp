// SPDX-License-Identifier: MIT
// How many edges published trees get under readings of the thesis that its text allows, and under
// two mistakes that are easy to make.
#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

GrowthResult grow_variant(const TreeParameters& parameters, const LoopOptions& options,
                          int threads) {
  const auto engine = engine_named("voxel_grid").create();
  return grow_crown(make_seedling(parameters), *engine, {.options = options, .threads = threads});
}

void run(ExperimentContext& context) {
  const TomlTable all = thesis_parameters();
  const std::vector<TomlTable> variants = all.tables("sensitivity");
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const std::string variant = variants[i].text("name");
    const std::string replacing =
        variants[i].has("tree") ? "sensitivity[" + std::to_string(i) + "].tree" : "";
    const LoopOptions options = loop_options_named(variants[i].text_or("option", "s"));
    for (const std::string& tree : all.table("sensitivity-trees").texts("names")) {
      context.progress(variant + " on " + tree);
      const TreeParameters parameters = thesis_tree(tree, replacing);
      const GrowthResult result = grow_variant(parameters, options, context.threads());
      const std::string name = tree + "/" + variant + "/";
      context.record({.experiment = {},
                      .measurement = name + "edges",
                      .value = static_cast<std::int64_t>(result.skeleton.edge_count()),
                      .seed = parameters.seed});
      context.record(name + "iterations", static_cast<std::int64_t>(result.passes.size()));
      context.record(name + "tree_hash", tree_hash(result.skeleton));
    }
  }
}

}  // namespace

extern const ExperimentDescriptor sensitivity;
constinit const ExperimentDescriptor sensitivity{
    .id = "brzoska2019/sensitivity",
    .question =
        "Which readings of the thesis' equations grow its published trees, and which grow others?",
    .source = "[Brzoska2019] sec. 3.4.4, 4.1, 5.2 and appendix table",
    .seconds = {5, 5, 5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
