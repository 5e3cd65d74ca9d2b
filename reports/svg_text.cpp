// SPDX-License-Identifier: MIT
#include "reports/svg_text.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/replace_all.hpp"

namespace phytobench {

namespace {

/// The root's start tag without its closing bracket; a quoted value may hold brackets.
std::string_view root_of(std::string_view svg) {
  const std::size_t start = svg.find("<svg");
  if (start == std::string_view::npos) return {};
  std::size_t end = start;
  for (bool quoted = false; end < svg.size() && (quoted || svg[end] != '>'); ++end)
    if (svg[end] == '"') quoted = !quoted;
  return svg.substr(start, end - start);
}

std::string_view attribute(std::string_view tag, std::string_view name) {
  const std::string opening = fmt::format(" {}=\"", name);
  const std::size_t start = tag.find(opening);
  if (start == std::string_view::npos) return {};
  const std::string_view value = tag.substr(start + opening.size());
  return value.substr(0, value.find('"'));
}

/// The text of a title or description that follows the root's start tag: those of parts further
/// inside are not meant.
std::string_view root_text(std::string_view svg, std::string_view element) {
  const std::string_view root = root_of(svg);
  if (root.empty()) return {};
  std::string_view rest = svg.substr(svg.find("<svg") + root.size());
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of("> \t\r\n"), rest.size()));
    if (!rest.starts_with("<title") && !rest.starts_with("<desc")) return {};
    const bool is_wanted = rest.substr(1).starts_with(element);
    rest.remove_prefix(std::min(rest.find('>') + 1, rest.size()));
    const std::string_view text = rest.substr(0, rest.find("</"));
    if (is_wanted) return text;
    rest.remove_prefix(std::min(rest.find('>', text.size()), rest.size()));
  }
}

/// What XML reserves, back as characters: a template escapes for its own format.
std::string without_entities(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 6> entities = {{{"&amp;", '&'},
                                                                          {"&lt;", '<'},
                                                                          {"&gt;", '>'},
                                                                          {"&quot;", '"'},
                                                                          {"&apos;", '\''},
                                                                          {"&#39;", '\''}}};
  std::string plain;
  while (!text.empty()) {
    const auto entity = std::find_if(entities.begin(), entities.end(),
                                     [&](const auto& e) { return text.starts_with(e.first); });
    plain += entity == entities.end() ? text.front() : entity->second;
    text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
  }
  return plain;
}

}  // namespace

std::string svg_caption(const std::string& svg) {
  const std::string_view label = attribute(root_of(svg), "aria-label");
  return without_entities(label.empty() ? root_text(svg, "title") : label);
}

std::string svg_description(const std::string& svg) {
  return without_entities(root_text(svg, "desc"));
}

double svg_width(const std::string& svg) {
  std::istringstream box{std::string(attribute(root_of(svg), "viewBox"))};
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  if (!(box >> left >> top >> width >> height) || !(width > 0.0)) return 0.0;
  return svg.find("<text") == std::string::npos ? std::max(width, plain_picture_width) : width;
}

std::string with_own_ids(const std::string& svg, const std::string& prefix) {
  std::string own = svg;
  for (const std::string_view start : {" id=\"", " id='", "url(#", "href=\"#", "href='#"})
    replace_all(own, start, std::string(start) + prefix + "-");
  constexpr std::string_view labels = " aria-labelledby=\"";
  for (std::size_t at = own.find(labels); at != std::string::npos; at = own.find(labels, at)) {
    at += labels.size();
    std::string ids = " " + own.substr(at, own.find('"', at) - at);
    const std::size_t length = ids.size() - 1;
    replace_all(ids, " ", " " + prefix + "-");
    own.replace(at, length, ids.substr(1));
  }
  return own;
}

}  // namespace phytobench
