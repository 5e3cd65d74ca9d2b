// SPDX-License-Identifier: MIT
#include "reports/render_template.hpp"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace {

using MustacheData = kainjow::mustache::data;
using nlohmann::ordered_json;

MustacheData mustache_data(const ordered_json& json) {
  if (json.is_object()) {
    MustacheData object{MustacheData::type::object};
    for (const auto& [key, value] : json.items()) object.set(key, mustache_data(value));
    return object;
  }
  if (json.is_array()) {
    MustacheData list{MustacheData::type::list};
    for (const ordered_json& element : json) list.push_back(mustache_data(element));
    return list;
  }
  if (json.is_boolean())
    return MustacheData{json.get<bool>() ? MustacheData::type::bool_true
                                         : MustacheData::type::bool_false};
  return MustacheData{json.is_string() ? json.get<std::string>() : json.dump()};
}

std::string escaped_for_html(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// For table cells and running text: what would start markup or end a cell.
std::string escaped_for_markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n') {
      escaped += ' ';
      continue;
    }
    if (c == '\\' || c == '|' || c == '*' || c == '_' || c == '`' || c == '<' || c == '[' ||
        c == ']')
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

constexpr int deepest_nesting = 16;

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// A part of a template without the end of its last line: its tag has one of its own.
std::string_view body_of(std::string_view part) {
  if (part.ends_with('\n')) part.remove_suffix(1);
  return part;
}

std::string expanded(std::string_view text, const Partials& partials, int depth) {
  constexpr std::string_view opening = "{{>", closing = "}}";
  if (depth > deepest_nesting) throw ContractViolation("a part of the report contains itself");
  std::string whole;
  while (!text.empty()) {
    const std::size_t start = text.find(opening);
    const std::size_t end =
        start == std::string_view::npos ? start : text.find(closing, start + opening.size());
    if (end == std::string_view::npos) return whole.append(text);
    const std::string name =
        trimmed(text.substr(start + opening.size(), end - start - opening.size()));
    whole.append(text.substr(0, start));
    text.remove_prefix(end + closing.size());
    const auto part = partials.find(name);
    if (part != partials.end())
      whole += expanded(body_of(part->second), partials, depth + 1);
    else if (text.starts_with('\n') && (whole.empty() || whole.back() == '\n'))
      text.remove_prefix(1);
  }
  return whole;
}

}  // namespace

std::string with_partials(std::string_view text, const Partials& partials) {
  return expanded(text, partials, 0);
}

std::string render_template(const std::string& text, const ordered_json& document,
                            EscapeFor format) {
  kainjow::mustache::mustache tmpl(text);
  if (!tmpl.is_valid()) throw ContractViolation("broken report template: " + tmpl.error_message());
  tmpl.set_custom_escape(format == EscapeFor::html ? escaped_for_html : escaped_for_markdown);
  return tmpl.render(mustache_data(document));
}

std::string render_report(const std::filesystem::path& folder, const ordered_json& document,
                          EscapeFor format) {
  const std::filesystem::path own = folder / (format == EscapeFor::html ? "html" : "md");
  const std::string text = read_text_file(own / "report.mustache");
  Partials partials;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(own))
    if (entry.path().extension() == ".mustache")
      partials[entry.path().stem().string()] = read_text_file(entry.path());
  return render_template(with_partials(text, partials), document, format);
}

}  // namespace phytobench
