// SPDX-License-Identifier: MIT
#include "reports/render_template.hpp"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using kainjow::mustache::data;
using nlohmann::ordered_json;

data mustache_data(const ordered_json& json) {
  if (json.is_object()) {
    data object{data::type::object};
    for (const auto& [key, value] : json.items()) object.set(key, mustache_data(value));
    return object;
  }
  if (json.is_array()) {
    data list{data::type::list};
    for (const ordered_json& element : json) list.push_back(mustache_data(element));
    return list;
  }
  if (json.is_boolean())
    return data{json.get<bool>() ? data::type::bool_true : data::type::bool_false};
  return data{json.is_string() ? json.get<std::string>() : json.dump()};
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

}  // namespace

std::string render_template(const std::string& text, const ordered_json& document,
                            EscapeFor format) {
  kainjow::mustache::mustache tmpl(text);
  if (!tmpl.is_valid()) throw ContractViolation("broken report template: " + tmpl.error_message());
  tmpl.set_custom_escape(format == EscapeFor::html ? escaped_for_html : escaped_for_markdown);
  return tmpl.render(mustache_data(document));
}

}  // namespace phytobench
