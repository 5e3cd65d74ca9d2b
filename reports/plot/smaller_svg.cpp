// SPDX-License-Identifier: MIT
#include "reports/plot/smaller_svg.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace phytobench {

namespace {

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\n") == std::string_view::npos;
}

std::string value_of(std::string_view tag, std::string_view opening) {
  const std::size_t start = tag.find(opening) + opening.size();
  return std::string(tag.substr(start, tag.find('\'', start) - start));
}

/// Dots one after another as one path of strokes without length: a fifth of their bytes.
std::string with_joined_dots(const std::string& svg) {
  constexpr std::string_view opening = "<use xlink:href='#gpDot'";
  std::string result, colour;
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t dot = std::min(svg.find(opening, at), svg.size());
    const std::string between = svg.substr(at, dot - at);
    const bool goes_on = is_blank(between);
    const std::size_t end = dot < svg.size() ? svg.find('>', dot) + 1 : svg.size();
    const std::string tag = svg.substr(dot, end - dot);
    const std::string own = tag.empty() ? "" : value_of(tag, " color='");
    if (!colour.empty() && (!goes_on || own != colour)) result += "'/>";
    if (!goes_on) result += between;
    if (!tag.empty() && (!goes_on || own != colour))
      result += fmt::format("<path stroke='{}' stroke-width='2' stroke-linecap='round' d='", own);
    if (!tag.empty())
      result += fmt::format("M{:.1f} {:.1f}h0", std::stod(value_of(tag, " x='")),
                            std::stod(value_of(tag, " y='")));
    colour = own;
    at = end;
  }
  return result;
}

/// Definitions that nothing refers to, left out. One a line; they refer to earlier ones only.
std::string with_used_definitions(const std::string& svg) {
  constexpr std::string_view opening = "<defs>\n", closing = "</defs>";
  const std::size_t start = svg.find(opening), end = svg.find(closing);
  if (start == std::string::npos || end == std::string::npos) return svg;
  const std::size_t first = start + opening.size();
  std::string used, rest = svg.substr(end);
  for (std::string_view lines(svg.data() + first, end - first); !lines.empty();) {
    lines.remove_suffix(lines.ends_with('\n') ? 1 : 0);
    const std::size_t line = lines.rfind('\n') + 1;  // 0 where there is none
    const std::string definition(lines.substr(line));
    const bool has_id = definition.find(" id='") != std::string::npos;
    if (has_id && rest.find("#" + value_of(definition, " id='") + "'") != std::string::npos) {
      used = definition + "\n" + used;
      rest += definition;
    }
    lines = lines.substr(0, line);
  }
  return svg.substr(0, first) + used + svg.substr(end);
}

std::string without_empty_groups(const std::string& svg) {
  std::string result;
  std::size_t empty_since = std::string::npos;  // where in the result a group begins that is empty
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t tag = std::min(svg.find('<', at), svg.size());
    const std::size_t end = std::min(svg.find('>', tag), svg.size() - 1) + 1;
    const std::string_view text(svg.data() + at, tag - at);
    const std::string_view markup(svg.data() + tag, end - tag);
    if (!is_blank(text)) empty_since = std::string::npos;
    if (markup == "</g>" && empty_since != std::string::npos) {
      result.resize(empty_since);
      empty_since = std::string::npos;
    } else {
      result += text;
      empty_since = markup.starts_with("<g ") ? result.size() : std::string::npos;
      result += markup;
    }
    at = std::max(end, tag + 1);
  }
  return result;
}

}  // namespace

std::string smaller_svg(const std::string& drawn) {
  return without_empty_groups(with_used_definitions(with_joined_dots(drawn)));
}

}  // namespace phytobench
