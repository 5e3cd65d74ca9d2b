// SPDX-License-Identifier: MIT
#include "experiments/brzoska2019/thesis_tree.hpp"

#include "core/colonization/tree_parameters_file.hpp"
#include "reference/data_folder.hpp"

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
  std::vector<std::string> tables{"tree." + name};
  if (!replacing_table.empty()) tables.push_back(replacing_table);
  return read_tree_parameters(parameters_file(), tables);
}

}  // namespace phytobench::experiments::brzoska2019
