// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/box_output.hpp"
#include "cli/build_findings.hpp"
#include "cli/json_values.hpp"
#include "cli/option_values.hpp"
#include "core/contract/counted_noun.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

// As in the files of graphs.
constexpr std::array<std::string_view, 3> surface_words{"bark", "leaf", "plain"};

std::string_view word_of(Surface surface) {
  return surface_words.at(static_cast<std::size_t>(surface));
}

ordered_json components_json(const ComponentGraph& graph, const BuildFindings& findings) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < graph.prototypes.size(); ++i) {
    const Prototype& prototype = graph.prototypes[i];
    rows.push_back({{"name", prototype.name},
                    {"kind", prototype.kind->name},
                    {"most_recursions", number_or_null(prototype.most_recursions)},
                    {"instances", findings.instances[i]},
                    {"predicted", number_or_null(findings.predicted.instances[i])}});
  }
  return rows;
}

ordered_json links_json(const ComponentGraph& graph, const BuildFindings& findings) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const ComponentLink& link = graph.links[i];
    rows.push_back({{"from", graph.prototypes[link.from].name},
                    {"to", graph.prototypes[link.to].name},
                    {"kind", name_of(link.kind)},
                    {"instances", findings.link_instances[i]}});
  }
  return rows;
}

ordered_json materials_json(const BuildFindings& findings) {
  ordered_json rows = ordered_json::array();
  for (const MaterialFindings& one : findings.materials)
    rows.push_back({{"name", one.name},
                    {"surface", word_of(one.material.surface)},
                    {"colour", to_text(one.material.colour)},
                    {"triangles", one.triangles},
                    {"vertices", one.vertices}});
  return rows;
}

ordered_json frame_json(const BuildFindings& frame) {
  return {{"time", frame.time},
          {"instances", frame.instance_count},
          {"triangles", frame.triangle_count()},
          {"vertices", frame.vertex_count()},
          {"box", box_json(frame.box)},
          {"files", frame.files}};
}

std::size_t width_of(std::string_view head, const std::vector<std::string>& cells) {
  std::size_t width = head.size();
  for (const std::string& cell : cells) width = std::max(width, cell.size());
  return width;
}

std::string count_or_dash(const std::optional<std::uint64_t>& count) {
  return count ? std::to_string(*count) : "-";
}

std::string component_table(const ComponentGraph& graph, const BuildFindings& findings) {
  std::vector<std::string> names;
  for (const Prototype& prototype : graph.prototypes) names.push_back(prototype.name);
  const std::size_t width = width_of("component", names);
  constexpr auto line = "{:<{}}  {:<8}  {:>9}  {:>9}\n";
  std::string text = fmt::format(line, "component", width, "kind", "instances", "predicted");
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format(line, names[i], width, graph.prototypes[i].kind->name,
                        findings.instances[i], count_or_dash(findings.predicted.instances[i]));
  return text;
}

std::string link_table(const ComponentGraph& graph, const BuildFindings& findings) {
  if (graph.links.empty()) return "";
  std::vector<std::string> names;
  for (const ComponentLink& link : graph.links)
    names.push_back(graph.prototypes[link.from].name + " -> " + graph.prototypes[link.to].name);
  const std::size_t width = width_of("link", names);
  constexpr auto line = "{:<{}}  {:<8}  {:>9}\n";
  std::string text = "\n" + fmt::format(line, "link", width, "kind", "instances");
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format(line, names[i], width, name_of(graph.links[i].kind),
                        findings.link_instances[i]);
  return text;
}

std::string material_table(const BuildFindings& findings) {
  std::vector<std::string> names;
  for (const MaterialFindings& one : findings.materials) names.push_back(one.name);
  const std::size_t width = width_of("material", names);
  constexpr auto line = "{:<{}}  {:<8}  {:>9}  {:>9}\n";
  std::string text = "\n" + fmt::format(line, "material", width, "colour", "triangles", "vertices");
  for (const MaterialFindings& one : findings.materials)
    text += fmt::format(line, one.name, width, to_text(one.material.colour), one.triangles,
                        one.vertices);
  if (findings.materials.size() > 1)
    text += fmt::format(line, "all", width, "", findings.triangle_count(), findings.vertex_count());
  return text;
}

/// Why numbers are missing in the column of predictions.
std::string prediction_line(const BuildFindings& findings) {
  if (findings.predicted.is_too_large)
    return "nothing is predicted: the grammar that counts would be too large\n";
  const auto& counts = findings.predicted.instances;
  const bool all = std::all_of(counts.begin(), counts.end(), [](const auto& c) { return bool(c); });
  return all ? "" : "-: not predicted, random() decides how many there are\n";
}

}  // namespace

std::string build_json(const ComponentGraph& graph, const std::vector<BuildFindings>& frames,
                       const PlantBuildOptions& options) {
  const BuildFindings& last = frames.back();
  ordered_json json{{"schema", "phytobench/build-1"},
                    {"graph", text_or_null(options.graph)},
                    {"preset", text_or_null(options.preset)},
                    {"seed", graph.seed},
                    {"time", last.time},
                    {"resolution", options.resolution.value_or(1.0)},
                    {"instances", last.instance_count},
                    {"edges", last.instance_count - 1},
                    {"levels", last.levels},
                    {"components", components_json(graph, last)},
                    {"links", links_json(graph, last)},
                    {"materials", materials_json(last)},
                    {"triangles", last.triangle_count()},
                    {"vertices", last.vertex_count()},
                    {"box", box_json(last.box)},
                    {"frames", ordered_json::array()},
                    {"files", ordered_json::array()}};
  for (const BuildFindings& frame : frames) {
    if (frames.size() > 1) json["frames"].push_back(frame_json(frame));
    for (const std::string& file : frame.files) json["files"].push_back(file);
  }
  return json_text(json) + "\n";
}

std::string build_text(const ComponentGraph& graph, const std::vector<BuildFindings>& frames,
                       const PlantBuildOptions& options) {
  const BuildFindings& last = frames.back();
  std::string text =
      fmt::format("{}: seed {}, time {:g}\n\n",
                  options.preset.empty() ? options.graph : "preset " + options.preset, graph.seed,
                  shown(last.time));
  text += component_table(graph, last) + prediction_line(last);
  text += link_table(graph, last) + material_table(last);
  text += fmt::format("\n{} on {}\n", counted_noun(last.instance_count, "instance"),
                      counted_noun(last.levels, "level"));
  text += last.box.empty() ? "no triangles\n" : "box " + box_text(last.box) + "\n";
  for (const BuildFindings& frame : frames)
    for (const std::string& file : frame.files) text += "wrote " + file + "\n";
  return text;
}

}  // namespace phytobench::cli
