// SPDX-License-Identifier: MIT
#include "reports/run_figures.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr double lettered_scale = 0.75;  ///< at which letters of 12 pixels can still be read
constexpr double plain_width = 544.0;    ///< pixels, of a picture without letters

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

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

/// The title that follows the root's start tag: those of parts further inside are not meant.
std::string_view root_title(std::string_view svg) {
  const std::string_view root = root_of(svg);
  if (root.empty()) return {};
  std::string_view rest = svg.substr(svg.find("<svg") + root.size());
  rest.remove_prefix(std::min(rest.find_first_not_of("> \t\r\n"), rest.size()));
  constexpr std::string_view opening = "<title>";
  if (!rest.starts_with(opening)) return {};
  rest.remove_prefix(opening.size());
  return rest.substr(0, rest.find("</title>"));
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

/// Digits of one number from the front of `text`, which loses them, without leading zeros.
std::string_view take_number(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && is_digit(text[length])) ++length;
  std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

/// Order in which step-40 comes before step-100 and 4.9 before 4.11.
bool is_naturally_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view first = take_number(a), second = take_number(b);
      if (first.size() != second.size()) return first.size() < second.size();
      if (first != second) return first < second;
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.empty() && !b.empty();
}

/// "alsweis/x/figures-7.6-7.7.svg" -> "7.6-7.7"; nothing without a number of a figure.
std::optional<std::string> figure_number(const std::string& artifact) {
  const std::string stem = std::filesystem::path(artifact).stem().string();
  for (const std::string_view opening : {"figure-", "figures-"})
    if (stem.starts_with(opening) && stem.size() > opening.size() && is_digit(stem[opening.size()]))
      return stem.substr(opening.size());
  return std::nullopt;
}

}  // namespace

std::string svg_caption(const std::string& svg) {
  const std::string_view label = attribute(root_of(svg), "aria-label");
  return without_entities(label.empty() ? root_title(svg) : label);
}

double svg_width(const std::string& svg) {
  std::istringstream box{std::string(attribute(root_of(svg), "viewBox"))};
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  if (!(box >> left >> top >> width >> height) || !(width > 0.0)) return 0.0;
  return svg.find("<text") == std::string::npos ? std::max(width, plain_width) : width;
}

bool is_figure_before(const std::string& a, const std::string& b) {
  const auto first = figure_number(a), second = figure_number(b);
  if (first.has_value() != second.has_value()) return first.has_value();
  if (first && *first != *second) return is_naturally_before(*first, *second);
  return is_naturally_before(a, b);
}

ordered_json figures_of(const std::string& paper,
                        const std::map<std::string, std::string>& pictures) {
  std::vector<std::string> names;
  for (const auto& [name, svg] : pictures)
    if (name.starts_with(paper + "/")) names.push_back(name);
  std::sort(names.begin(), names.end(), is_figure_before);
  ordered_json figures = ordered_json::array();
  for (const std::string& name : names) {
    const std::string& svg = pictures.at(name);
    const std::string caption = svg_caption(svg);
    const double width = svg_width(svg);
    const bool lettered = svg.find("<text") != std::string::npos;
    figures.push_back(
        {{"name", name},
         {"caption", caption.empty() ? name : caption},
         {"svg", svg},
         {"width", fmt::format("{:.0f}", width > 0.0 ? width : plain_width)},
         {"least_width", fmt::format("{:.0f}", lettered ? lettered_scale * width : 0)}});
  }
  return figures;
}

}  // namespace phytobench
