// SPDX-License-Identifier: MIT
#include "core/terrain/files/coordinate_unit.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using UnitKind = CoordinateUnit::Kind;

/// The factor of the last UNIT["name",factor]: that of a projection stands behind those of the
/// ellipsoid's angles. 1 where there is none.
double last_unit_factor(std::string_view text) {
  double factor = 1.0;
  for (std::size_t at = text.find("UNIT["); at != std::string_view::npos;
       at = text.find("UNIT[", at + 1)) {
    const std::size_t name_end = text.find('"', text.find('"', at) + 1);
    const std::size_t comma = text.find(',', name_end);
    if (comma == std::string_view::npos) break;
    std::string_view number = text.substr(comma + 1);
    while (number.starts_with(' ')) number.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error == std::errc() && std::isfinite(value) && value > 0.0) factor = value;
  }
  return factor;
}

bool begins_with_any(std::string_view text, std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words)
    if (text.starts_with(word)) return true;
  return false;
}

void check_given(const std::optional<double>& size, const char* key, const std::string& name) {
  if (size && !(std::isfinite(*size) && *size > 0.0))
    throw InputError(
        fmt::format("{}: {} = {} is no length; give metres above 0", name, key, *size));
}

/// Nothing where the file has no place.
std::optional<CellSize> size_in_file(const Raster& raster, const std::string& name) {
  if (!raster.place) return std::nullopt;
  const GeoReference& place = *raster.place;
  const double width = std::abs(place.column_step), depth = std::abs(place.row_step);
  CoordinateUnit unit = raster.unit;
  if (unit.kind == UnitKind::not_said) unit = likely_unit(place, raster.columns, raster.rows);
  if (unit.kind == UnitKind::lengths) return CellSize{width * unit.metres, depth * unit.metres};
  const double middle = place.north + place.row_step * raster.rows / 2.0;
  // Half a cell beyond a pole is how maps of vertices end there.
  const double reach = std::abs(middle) + depth * (raster.rows - 1) / 2.0;
  if (!(reach <= 90.0))
    throw InputError(
        fmt::format("{}: its degrees reach to latitude {}, beyond the pole; set "
                    "cell_width and cell_depth in metres",
                    name, reach));
  const DegreeLength degree = degree_length(middle);
  return CellSize{width * degree.east, depth * degree.north};
}

}  // namespace

CoordinateUnit unit_of_projection(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
    text.remove_prefix(1);
  if (begins_with_any(text, {"GEOGCS[", "GEOGCRS[", "GEODCRS["})) return {UnitKind::degrees};
  if (begins_with_any(text, {"PROJCS[", "PROJCRS["}))
    return {UnitKind::lengths, last_unit_factor(text)};
  if (begins_with_any(text, {"Projection", "PROJECTION"}))
    return {text.find("GEOGRAPHIC") == std::string_view::npos ? UnitKind::lengths
                                                              : UnitKind::degrees};
  return {};
}

CoordinateUnit likely_unit(const GeoReference& place, int columns, int rows) {
  const double east = place.west + place.column_step * columns;
  const double south = place.north + place.row_step * rows;
  const bool begins_at_0 = place.west == 0.0 && (place.north == 0.0 || std::abs(south) < 1e-9);
  const bool fits = place.west >= -180.0 && east <= 360.0 && south >= -90.5 && place.north <= 90.5;
  constexpr double widest = 0.1;
  const bool is_narrow = std::abs(place.column_step) < widest && std::abs(place.row_step) < widest;
  return {fits && is_narrow && !begins_at_0 ? UnitKind::degrees : UnitKind::lengths};
}

DegreeLength degree_length(double latitude_degrees) {
  constexpr double semi_major_axis_m = 6378137.0, flattening = 1.0 / 298.257223563;
  constexpr double eccentricity_squared = flattening * (2.0 - flattening);
  constexpr double degree = std::numbers::pi / 180.0;
  const double sine = std::sin(latitude_degrees * degree);
  const double w = 1.0 - eccentricity_squared * sine * sine;
  const double across = semi_major_axis_m / std::sqrt(w);
  const double along = across * (1.0 - eccentricity_squared) / w;
  return {degree * across * std::cos(latitude_degrees * degree), degree * along};
}

CellSize cell_size(const Raster& raster, const HeightFileOptions& options,
                   const std::string& name) {
  check_given(options.cell_width, "cell_width", name);
  check_given(options.cell_depth, "cell_depth", name);
  if (options.cell_width && options.cell_depth) return {*options.cell_width, *options.cell_depth};
  const std::optional<CellSize> own = size_in_file(raster, name);
  const bool one_is_given = options.cell_width || options.cell_depth;
  if (own && one_is_given)
    throw InputError(
        fmt::format("{}: has cells of {} x {} m itself, and only one of cell_width and "
                    "cell_depth is given; give both or none",
                    name, own->width, own->depth));
  if (own) return *own;
  if (!one_is_given)
    throw InputError(
        fmt::format("{}: does not say how wide its cells are; set cell_width (and "
                    "cell_depth where they are not square) in metres",
                    name));
  const double side = options.cell_width ? *options.cell_width : *options.cell_depth;
  return {side, side};
}

}  // namespace phytobench
