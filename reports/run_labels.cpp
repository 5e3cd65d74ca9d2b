// SPDX-License-Identifier: MIT
#include "reports/run_labels.hpp"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

namespace phytobench {

namespace {

using nlohmann::json;

std::string text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The build system's names of compilers are not everybody's.
std::string compiler_of(const json& environment) {
  const std::string compiler = text_at(environment, "compiler");
  return compiler.starts_with("GNU ") ? "GCC " + compiler.substr(4) : compiler;
}

std::string machine_label(const RunOrigin& run) {
  const json environment = json::parse(run.environment_json);
  const std::string compiler = compiler_of(environment);
  const auto machine = environment.find("machine");
  const std::string processor =
      machine != environment.end() && machine->is_object() ? text_at(*machine, "processor") : "";
  if (compiler.empty() || processor.empty()) return compiler + processor;
  return compiler + " on " + processor;
}

std::string folder_name(const RunOrigin& run) {
  const std::filesystem::path path = std::filesystem::path(run.folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

bool is_only_one(const std::vector<std::string>& labels, const std::string& label) {
  return std::count(labels.begin(), labels.end(), label) == 1;
}

std::string with_place(const std::string& label, const std::string& place) {
  return label.empty() ? place : label + " (" + place + ")";
}

}  // namespace

std::vector<std::string> run_labels(std::span<const RunOrigin> runs) {
  std::vector<std::string> machines, named, labels;
  for (const RunOrigin& run : runs) machines.push_back(machine_label(run));
  for (std::size_t i = 0; i < runs.size(); ++i)
    named.push_back(!machines[i].empty() && is_only_one(machines, machines[i])
                        ? machines[i]
                        : with_place(machines[i], folder_name(runs[i])));
  for (std::size_t i = 0; i < runs.size(); ++i)
    labels.push_back(is_only_one(named, named[i]) ? named[i]
                                                  : with_place(machines[i], runs[i].folder));
  return labels;
}

}  // namespace phytobench
