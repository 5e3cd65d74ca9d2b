// SPDX-License-Identifier: MIT
#include "reports/svg_tokens.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "reports/svg_path_data.hpp"

namespace phytobench {

namespace {

/// A quoted value may hold the end of a tag.
std::size_t end_of_tag(const std::string& svg, std::size_t at) {
  char quote = 0;
  for (; at < svg.size(); ++at) {
    if (quote != 0)
      quote = svg[at] == quote ? '\0' : quote;
    else if (svg[at] == '"' || svg[at] == '\'')
      quote = svg[at];
    else if (svg[at] == '>')
      return at + 1;
  }
  return svg.size();
}

/// "rgb( 36, 123, 224)" -> "#247be0".
std::string plain_colour(const std::string& value) {
  if (!value.starts_with("rgb(")) return value;
  std::string colour = "#";
  for (std::size_t at = 4; at < value.size();) {
    const std::size_t first = value.find_first_not_of(" ,", at);
    if (first == std::string::npos) return value;
    unsigned part = 0;
    const auto [end, error] =
        std::from_chars(value.data() + first, value.data() + value.size(), part);
    if (error != std::errc{} || part > 255) return value;
    colour += fmt::format("{:02x}", part);
    at = static_cast<std::size_t>(end - value.data());
    if (value[at] == ')') return colour.size() == 7 ? colour : value;
  }
  return value;
}

/// A tag with single spaces between its attributes.
std::string plain_tag(const std::string& tag) {
  std::string text;
  for (std::size_t i = 0; i < tag.size(); ++i) {
    const char c = tag[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = tag.find(c, i + 1);
      if (end == std::string::npos) return text + tag.substr(i);
      const std::string value = tag.substr(i + 1, end - i - 1);
      text += c + (text.ends_with(" d=") ? spaceless_path_data(value) : plain_colour(value)) + c;
      i = end;
    } else if (!is_space(c)) {
      if ((c == '>' || c == '/') && text.ends_with(' ')) text.pop_back();
      text += c;
    } else if (!text.ends_with(' ')) {
      text += ' ';
    }
  }
  return text;
}

/// Letters and descriptions keep their space.
bool is_worded(const std::string& token) {
  return opens(token, "text") || opens(token, "title") || opens(token, "desc") ||
         opens(token, "style");
}

}  // namespace

bool opens(const std::string& token, std::string_view name) {
  return token.starts_with("<" + std::string(name)) && token.size() > name.size() + 1 &&
         (is_space(token[name.size() + 1]) || token[name.size() + 1] == '>') &&
         !token.ends_with("/>");
}

std::string attribute_of(const std::string& tag, const std::string& name) {
  const std::size_t start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return "";
  const std::size_t first = start + name.size() + 3;
  return tag.substr(first, tag.find('"', first) - first);
}

SvgTokens svg_tokens(const std::string& svg) {
  SvgTokens tokens;
  bool worded = false;
  for (std::size_t at = 0; at < svg.size();) {
    const bool is_tag = svg[at] == '<';
    const std::size_t end = is_tag ? end_of_tag(svg, at) : std::min(svg.find('<', at), svg.size());
    std::string token = svg.substr(at, end - at);
    at = end;
    if (is_tag && std::isalpha(static_cast<unsigned char>(token[1]))) token = plain_tag(token);
    if (!is_tag && !worded && std::all_of(token.begin(), token.end(), is_space)) continue;
    if (is_worded(token)) worded = true;
    if (token == "</text>" || token == "</title>" || token == "</desc>" || token == "</style>")
      worded = false;
    tokens.push_back(std::move(token));
  }
  return tokens;
}

}  // namespace phytobench
