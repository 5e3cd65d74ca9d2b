// SPDX-License-Identifier: MIT
#include "experiments/brzoska2019/thesis_tree.hpp"

#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "reference/data_folder.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

std::filesystem::path parameters_file() {
  return paper_folder("brzoska2019") / "parameters.toml";
}

}  // namespace

TomlTable thesis_parameters() {
  return TomlTable::read(parameters_file());
}

TreeParameters thesis_tree(const std::string& name, const std::string& replacing_table) {
  std::vector<TreeSource> sources{{tree_preset_file(name), ""}};
  if (!replacing_table.empty()) sources.push_back({parameters_file(), replacing_table});
  return read_tree_parameters(sources);
}

Skeleton grow_thesis_tree(const TreeParameters& parameters, int threads) {
  const auto engine = engine_named("node_driven").create();
  return grow_crown(make_seedling(parameters), *engine,
                    {.options = loop_options_named("dn"), .threads = threads})
      .skeleton;
}

}  // namespace phytobench::experiments::brzoska2019
