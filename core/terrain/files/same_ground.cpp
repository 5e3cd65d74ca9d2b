// SPDX-License-Identifier: MIT
#include "core/terrain/files/same_ground.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/files/coordinate_unit.hpp"
#include "core/terrain/files/number_words.hpp"

namespace phytobench {

namespace {

struct Borders {
  double west, south, east, north;
};

Borders borders_of(const GeoReference& place, int columns, int rows) {
  return {place.west, place.north + place.row_step * rows, place.west + place.column_step * columns,
          place.north};
}

bool begins_at_0(const Borders& borders) {
  return borders.west == 0.0 && (borders.north == 0.0 || std::abs(borders.south) < 1e-9);
}

/// A vertex then still lies in its own cell of the other map.
bool are_close(const Borders& a, const Borders& b, const GeoReference& cell) {
  constexpr double half_a_cell = 0.5 + 1e-6;  // and what rounding adds
  const double east = half_a_cell * std::abs(cell.column_step);
  const double north = half_a_cell * std::abs(cell.row_step);
  return std::abs(a.west - b.west) <= east && std::abs(a.east - b.east) <= east &&
         std::abs(a.south - b.south) <= north && std::abs(a.north - b.north) <= north;
}

std::string shown(const Borders& borders) {
  return fmt::format("from {:.10g}, {:.10g} to {:.10g}, {:.10g}", borders.west, borders.south,
                     borders.east, borders.north);
}

/// The numbers of PARAMETER["name",number], by their names in small letters: those of ESRI and of
/// others differ in nothing else.
std::map<std::string, double> parameters_of(std::string_view text) {
  constexpr std::string_view start = "PARAMETER[\"";
  std::map<std::string, double> parameters;
  for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at)) {
    at += start.size();
    const std::size_t name_end = text.find('"', at);
    const std::size_t comma = text.find(',', name_end);
    const std::size_t end = text.find_first_of(",]", comma + 1);
    if (name_end == std::string_view::npos || comma == std::string_view::npos) break;
    std::string name(text.substr(at, name_end - at));
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::string_view words = text.substr(comma + 1, end - comma - 1);
    if (const auto value = number_of(next_word(words))) parameters.emplace(name, *value);
  }
  return parameters;
}

bool differ(double a, double b) {
  constexpr double printed = 1e-6;  // relative: texts print as many digits as they like
  return std::abs(a - b) > printed * std::max({1.0, std::abs(a), std::abs(b)});
}

bool are_different(const std::string& a, const std::string& b) {
  const CoordinateUnit one = unit_of_projection(a), other = unit_of_projection(b);
  constexpr auto not_said = CoordinateUnit::Kind::not_said;
  if (one.kind == not_said || other.kind == not_said) return false;
  if (one.kind != other.kind || differ(one.metres, other.metres)) return true;
  const std::map<std::string, double> others = parameters_of(b);
  for (const auto& [name, value] : parameters_of(a))
    if (const auto found = others.find(name); found != others.end() && differ(value, found->second))
      return true;
  return false;
}

/// "WGS 84 / UTM zone 32N".
std::string name_of(const std::string& projection) {
  const std::size_t start = projection.find('"');
  if (start == std::string::npos) return shown_word(projection);
  return shown_word(projection.substr(start + 1, projection.find('"', start + 1) - start - 1));
}

}  // namespace

void refuse_other_ground(const PlacedMap& map, const PlacedMap& heights, int columns, int rows) {
  const std::string &one = map.place.projection, &other = heights.place.projection;
  if (are_different(one, other))
    throw InputError(
        fmt::format("{}: is a map in '{}', and {} one in '{}'; give maps in the same "
                    "projection",
                    map.name, name_of(one), heights.name, name_of(other)));
  const Borders its = borders_of(map.place, columns, rows);
  const Borders theirs = borders_of(heights.place, columns, rows);
  Borders moved = its;
  if (begins_at_0(its) != begins_at_0(theirs))
    moved = {theirs.west, theirs.north - (its.north - its.south),
             theirs.west + (its.east - its.west), theirs.north};
  if (!are_close(moved, theirs, heights.place))
    throw InputError(fmt::format("{}: reaches {}, and {} {}; give maps of the same ground",
                                 map.name, shown(its), heights.name, shown(theirs)));
}

}  // namespace phytobench
