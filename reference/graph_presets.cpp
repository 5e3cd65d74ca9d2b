// SPDX-License-Identifier: MIT
#include "reference/graph_presets.hpp"

namespace phytobench {

std::vector<GraphPreset> graph_presets() {
  return preset_files("graphs");
}

std::filesystem::path graph_preset_file(const std::string& name) {
  return preset_file_named("graphs", {&name, 1});
}

}  // namespace phytobench
