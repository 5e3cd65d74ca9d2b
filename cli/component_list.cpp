// SPDX-License-Identifier: MIT
#include "cli/component_list.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/component_graph/component_registry.hpp"

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

std::string component_list_text() {
  std::size_t width = 0;
  for (const ComponentKind* kind : all_component_kinds())
    width = std::max(width, kind->name.size());
  std::string text;
  for (const ComponentKind* kind : all_component_kinds())
    text += fmt::format("{:<{}}  {}{}\n", kind->name, width,
                        kind->built() ? "" : fmt::format("[not built: {}] ", kind->missing_package),
                        kind->summary);
  return text;
}

}  // namespace phytobench::cli
