// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/box_output.hpp"
#include "cli/derive_findings.hpp"
#include "cli/json_values.hpp"
#include "cli/option_values.hpp"
#include "core/contract/counted_noun.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

/// As digits: numbers in JSON end early.
ordered_json digits_or_null(const std::optional<ExactCount>& count) {
  return count ? ordered_json(count->digits) : ordered_json(nullptr);
}

std::vector<std::string> properties_of(const LSystem& system) {
  const LSystemKind kind = kind_of(system);
  std::vector<std::string> properties;
  if (kind.is_d0l()) properties.emplace_back("D0L-system");
  if (kind.parametric) properties.emplace_back("parametric");
  if (kind.stochastic) properties.emplace_back("stochastic");
  if (kind.conditional) properties.emplace_back("conditional");
  if (kind.contextual) properties.emplace_back("context-sensitive");
  if (kind.queries) properties.emplace_back("asks the turtle");
  return properties;
}

ordered_json symbols_json(const LSystem& system, const DeriveFindings& findings) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < system.symbols.size(); ++i) {
    const Symbol& symbol = system.symbols[i];
    rows.push_back(
        {{"letter", symbol.letter},
         {"parameters", symbol.arity},
         {"count", number_or_null(findings.symbols[i])},
         {"predicted", findings.predicted ? ordered_json(findings.predicted->symbols[i].digits)
                                          : ordered_json(nullptr)}});
  }
  return rows;
}

ordered_json drawing_json(const DeriveFindings& findings) {
  if (!findings.drawn) return nullptr;
  const DrawnExtent& drawn = *findings.drawn;
  const bool streamed = !findings.made;
  return {{"streamed", streamed},
          {"segments", drawn.segments},
          {"predicted_segments", findings.predicted ? digits_or_null(findings.predicted->segments)
                                                    : ordered_json(nullptr)},
          {"length", drawn.length},
          {"box", box_json(drawn.segment_box)},
          {"polygons", streamed ? ordered_json(nullptr) : ordered_json(drawn.polygons)},
          {"polygon_box", box_json(drawn.polygon_box)}};
}

ordered_json tree_json(const std::optional<DrawnTree>& tree) {
  if (!tree) return nullptr;
  return {{"nodes", tree->nodes},
          {"tips", tree->tips},
          {"largest_degree", tree->largest_degree},
          {"depth", tree->depth},
          {"root_radius", tree->root_radius}};
}

std::string digits_or_dash(const std::optional<std::uint64_t>& number) {
  return number ? std::to_string(*number) : "-";
}

struct SymbolRow {
  std::string name, count, predicted;
};

/// A word that is too long has predicted numbers alone; they have all their digits.
std::vector<SymbolRow> symbol_rows(const LSystem& system, const DeriveFindings& findings) {
  const auto& predicted = findings.predicted;
  const bool counted = findings.made || !predicted;
  std::vector<SymbolRow> rows{{"symbol", counted ? "count" : "", "predicted"}};
  const auto add = [&](const std::string& name, const std::optional<std::uint64_t>& count,
                       const std::string& digits) {
    rows.push_back({name, counted ? digits_or_dash(count) : "", predicted ? digits : "-"});
  };
  for (std::size_t i = 0; i < system.symbols.size(); ++i)
    add(name_of(system.symbols[i]), findings.symbols[i],
        predicted ? predicted->symbols[i].digits : "");
  add("all", findings.modules, predicted ? predicted->modules.digits : "");
  return rows;
}

std::string symbol_table(const LSystem& system, const DeriveFindings& findings) {
  const std::vector<SymbolRow> rows = symbol_rows(system, findings);
  std::size_t name = 0, count = 0, predicted = 0;
  for (const SymbolRow& row : rows) {
    name = std::max(name, row.name.size());
    count = std::max(count, row.count.size());
    predicted = std::max(predicted, row.predicted.size());
  }
  std::string text;
  for (const SymbolRow& row : rows) {
    text += fmt::format("{:<{}}", row.name, name);
    if (count > 0) text += fmt::format("  {:>{}}", row.count, count);
    text += fmt::format("  {:>{}}\n", row.predicted, predicted);
  }
  if (!findings.predicted) text += "-: not predicted, " + findings.not_predicted + "\n";
  if (!findings.predicted && !findings.modules)
    text += "a count of -: more than 18446744073709551615\n";
  return text;
}

std::string in_steps(int steps) {
  return counted_noun(static_cast<std::uint64_t>(steps), "step");
}

std::string word_line(const DeriveFindings& findings, const LSystemDeriveOptions& options) {
  if (findings.made) return "";
  const bool is_counted = findings.modules || findings.predicted;
  return fmt::format(
      "\nthe word is {}: it has more than {} (--most-modules) or four times as many parameters; "
      "{}\n",
      is_counted ? "counted, not made" : "neither counted nor made",
      counted_noun(static_cast<std::uint64_t>(options.most_modules), "module"),
      *findings.longest_made < 0
          ? "so has the axiom"
          : in_steps(*findings.longest_made) + (*findings.longest_made == 1 ? " is" : " are") +
                " the most");
}

std::string drawing_lines(const DeriveFindings& findings) {
  if (!findings.drawn) return "\nnot drawn: " + findings.not_drawn + "\n";
  const DrawnExtent& drawn = *findings.drawn;
  if (drawn.segments == 0 && drawn.polygons == 0) return "\nnothing is drawn\n";
  std::string text = "\n";
  if (drawn.segments > 0)
    text += fmt::format("{} of total length {:.10g}{}\n", counted_noun(drawn.segments, "segment"),
                        drawn.length, findings.made ? "" : ", drawn without the word");
  if (!drawn.segment_box.empty()) text += "box " + box_text(drawn.segment_box) + "\n";
  if (drawn.polygons == 0) return text;
  text += counted_noun(drawn.polygons, "polygon");
  if (!drawn.polygon_box.empty()) text += ", box " + box_text(drawn.polygon_box);
  return text + "\n";
}

std::string tree_line(const DeriveFindings& findings) {
  if (!findings.made || findings.drawn->segments == 0) return "";
  if (!findings.tree) return "no tree: " + findings.no_tree + "\n";
  const DrawnTree& tree = *findings.tree;
  return fmt::format(
      "a tree of {}, {} of them {}; largest degree {}, depth {}, radius of the root {:.4g}\n",
      counted_noun(tree.nodes, "node"), tree.tips, tree.tips == 1 ? "a tip" : "tips",
      tree.largest_degree, tree.depth, tree.root_radius);
}

}  // namespace

std::string derive_json(const LSystem& system, const DeriveFindings& findings,
                        const LSystemDeriveOptions& options) {
  ordered_json json{
      {"schema", "phytobench/derive-1"},
      {"system", options.system},
      {"preset", text_or_null(options.preset)},
      {"steps", system.steps},
      {"seed", system.seed},
      {"properties", properties_of(system)},
      {"made", findings.made},
      {"modules", number_or_null(findings.modules)},
      {"predicted_modules", findings.predicted ? ordered_json(findings.predicted->modules.digits)
                                               : ordered_json(nullptr)},
      {"not_predicted", text_or_null(findings.not_predicted)},
      {"parameters", findings.made ? ordered_json(findings.parameters) : ordered_json(nullptr)},
      {"word_hash", text_or_null(findings.word_hash)},
      {"word", findings.word ? ordered_json(*findings.word) : ordered_json(nullptr)},
      {"symbols", symbols_json(system, findings)},
      {"drawing", drawing_json(findings)},
      {"not_drawn", text_or_null(findings.not_drawn)},
      {"tree", tree_json(findings.tree)},
      {"no_tree", text_or_null(findings.no_tree)},
      {"files", findings.files}};
  return json_text(json) + "\n";
}

std::string derive_text(const LSystem& system, const DeriveFindings& findings,
                        const LSystemDeriveOptions& options) {
  std::string text = fmt::format(
      "{}: {}, {}{}\n\n", options.preset.empty() ? options.system : "preset " + options.preset,
      in_steps(system.steps), fmt::join(properties_of(system), ", "),
      kind_of(system).stochastic ? fmt::format(", seed {}", system.seed) : "");
  text += symbol_table(system, findings) + word_line(findings, options);
  text += drawing_lines(findings) + tree_line(findings);
  for (const std::string& file : findings.files) text += "wrote " + file + "\n";
  return text;
}

}  // namespace phytobench::cli
