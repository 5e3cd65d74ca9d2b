// SPDX-License-Identifier: MIT
#include "reports/document_provenance.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string text_of(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const ordered_json& element : value) text += (text.empty() ? "" : ", ") + text_of(element);
  return text;
}

void add_fact(ordered_json& rows, std::string name, const ordered_json& value) {
  std::replace(name.begin(), name.end(), '_', ' ');
  rows.push_back({{"name", name}, {"value", text_of(value)}});
}

}  // namespace

ordered_json environment_rows(const ordered_json& environment) {
  ordered_json rows = ordered_json::array();
  for (const auto& [key, value] : environment.items()) {
    if (key == "schema") continue;
    if (value.is_object())
      for (const auto& [inner, inner_value] : value.items())
        add_fact(rows, key + ": " + inner, inner_value);
    else
      add_fact(rows, key, value);
  }
  return rows;
}

std::string machine_line(const ordered_json& environment) {
  if (!environment.contains("machine") || !environment["machine"].is_object()) return "";
  const ordered_json& machine = environment["machine"];
  std::string line = machine.value("processor", "unknown processor");
  if (machine.contains("logical_processors"))
    line += fmt::format(", {} logical processors", machine["logical_processors"].dump());
  if (machine.value("virtual_machine", false)) line += ", in a virtual machine";
  if (environment.contains("threads"))
    line += fmt::format("; {} thread{}", environment["threads"].dump(),
                        environment["threads"] == 1 ? "" : "s");
  return line + "; " + environment.value("compiler", "unknown compiler") + ".";
}

}  // namespace phytobench
