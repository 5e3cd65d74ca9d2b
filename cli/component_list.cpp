// SPDX-License-Identifier: MIT
#include "cli/component_list.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"
#include "reference/graph_presets.hpp"

namespace phytobench::cli {

using nlohmann::ordered_json;

ordered_json component_rows() {
  ordered_json rows = ordered_json::array();
  for (const ComponentKind* kind : all_component_kinds()) {
    ordered_json keys = ordered_json::array();
    for (const ComponentKey& key : kind->keys)
      keys.push_back({{"name", key.name},
                      {"unit", key.unit},
                      {"meaning", key.meaning},
                      {"source", key.source},
                      {"default", key.default_text}});
    rows.push_back({{"id", kind->name},
                    {"source", kind->source},
                    {"built", kind->built()},
                    {"missing_package", kind->missing_package},
                    {"is_multiplier", kind->is_multiplier},
                    {"carries_branches", kind->carries_branches},
                    {"keys", keys},
                    {"summary", kind->summary}});
  }
  return rows;
}

namespace {

struct Example {
  std::string name;
  std::string summary;
};

std::vector<Example> examples() {
  std::vector<Example> all;
  for (const ComponentKind* kind : all_component_kinds())
    all.push_back(
        {std::string(kind->name),
         fmt::format("{}{}",
                     kind->built() ? "" : fmt::format("[not built: {}] ", kind->missing_package),
                     kind->summary)});
  for (const GraphPreset& preset : graph_presets()) all.push_back({preset.name, preset.summary});
  return all;
}

std::string example_list() {
  const std::vector<Example> all = examples();
  std::size_t width = 0;
  for (const Example& example : all) width = std::max(width, example.name.size());
  std::string text;
  for (const Example& example : all)
    text += fmt::format("{:<{}}  {}\n", example.name, width, example.summary);
  return text;
}

}  // namespace

std::string component_example(const std::string& name) {
  if (name == "list") return example_list();
  for (const ComponentKind* kind : all_component_kinds())
    if (kind->name == name) return example_component_graph(component_kind_named(name));
  for (const GraphPreset& preset : graph_presets())
    if (preset.name == name) return read_text_file(preset.file);
  std::vector<std::string> known;
  for (const Example& example : examples()) known.push_back(example.name);
  throw InputError("--example " + name + ": no kind of component and no preset" +
                   did_you_mean(name, known) + "; --example list names both");
}

}  // namespace phytobench::cli
