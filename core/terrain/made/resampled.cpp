// SPDX-License-Identifier: MIT
#include "core/terrain/made/resampled.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/terrain/files/raster.hpp"

namespace phytobench {

namespace {

/// Between two vertices, the second of which may not be asked.
struct BetweenVertices {
  int first = 0;
  double share = 0.0;  ///< of the second; exactly 0 on the first
};

/// Rounding must neither lose the last vertex nor ask for one beyond it.
std::vector<BetweenVertices> samples(int count, double side, double cell) {
  constexpr double rounding = 1e-9;
  const double extent = (count - 1) * side / cell;
  if (extent >= static_cast<double>(most_vertices))
    throw InputError(fmt::format("cells of {} m make more than {} vertices; take wider ones", cell,
                                 most_vertices));
  std::vector<BetweenVertices> places(static_cast<std::size_t>(extent * (1.0 + rounding)) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    double at = static_cast<double>(i) * cell / side;
    const double nearest = std::round(at);
    if (std::abs(at - nearest) <= rounding * std::max(1.0, nearest)) at = nearest;
    const double first = std::floor(at);
    places[i] = {static_cast<int>(first), at - first};
  }
  return places;
}

/// No data of a vertex counts where it has a share.
double mixed(double first, double second, double share) {
  return share == 0.0 ? first : first + share * (second - first);
}

double bilinear(const HeightField& field, const BetweenVertices& x, const BetweenVertices& y) {
  const auto along_row = [&](int row) {
    const double first = field.at(x.first, row);
    return mixed(first, x.share == 0.0 ? first : field.at(x.first + 1, row), x.share);
  };
  const double north = along_row(y.first);
  return y.share == 0.0 ? north : mixed(north, along_row(y.first + 1), y.share);
}

/// 0 1 2 1 0 1 2 ... for three.
int mirrored_index(int index, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1), at = index % period;
  return at < count ? at : period - at;
}

}  // namespace

HeightField on_square_cells(const HeightField& field, double cell_m) {
  PHYTOBENCH_EXPECT(cell_m > 0.0);
  const std::vector<BetweenVertices> x = samples(field.columns(), field.cell_width(), cell_m);
  const std::vector<BetweenVertices> y = samples(field.rows(), field.cell_depth(), cell_m);
  check_raster_size(static_cast<std::int64_t>(x.size()), static_cast<std::int64_t>(y.size()),
                    fmt::format("on cells of {} m", cell_m));
  HeightField result(static_cast<int>(x.size()), static_cast<int>(y.size()), cell_m, cell_m);
  for (int row = 0; row < result.rows(); ++row)
    for (int column = 0; column < result.columns(); ++column)
      result.at(column, row) =
          bilinear(field, x[static_cast<std::size_t>(column)], y[static_cast<std::size_t>(row)]);
  return result;
}

HeightField cropped(const HeightField& field, const MapPart& part) {
  const bool fits = part.first_column >= 0 && part.first_row >= 0 && part.columns > 0 &&
                    part.rows > 0 && part.columns <= field.columns() - part.first_column &&
                    part.rows <= field.rows() - part.first_row;
  if (!fits)
    throw InputError(fmt::format(
        "a part of {} x {} vertices from column {} and row {} is not on a "
        "map of {} x {}; take a smaller one",
        part.columns, part.rows, part.first_column, part.first_row, field.columns(), field.rows()));
  HeightField result(part.columns, part.rows, field.cell_width(), field.cell_depth());
  for (int row = 0; row < part.rows; ++row)
    std::copy_n(field.row(part.first_row + row) + part.first_column, part.columns,
                &result.at(0, row));
  return result;
}

HeightField tiled(const HeightField& field, int columns, int rows) {
  check_raster_size(columns, rows, "a map of tiles");
  HeightField result(columns, rows, field.cell_width(), field.cell_depth());
  for (int row = 0; row < rows; ++row) {
    const double* source = field.row(mirrored_index(row, field.rows()));
    for (int column = 0; column < columns; ++column)
      result.at(column, row) = source[mirrored_index(column, field.columns())];
  }
  return result;
}

GeoReference place_of_part(const GeoReference& place, const MapPart& part) {
  GeoReference result = place;
  result.west += part.first_column * place.column_step;
  result.north += part.first_row * place.row_step;
  return result;
}

GeoReference place_on_cells(const GeoReference& place, const HeightField& field,
                            const HeightField& resampled) {
  GeoReference result = place;
  result.column_step *= resampled.cell_width() / field.cell_width();
  result.row_step *= resampled.cell_depth() / field.cell_depth();
  // The first vertex, in the middle of its cell, stays.
  result.west += (place.column_step - result.column_step) / 2.0;
  result.north += (place.row_step - result.row_step) / 2.0;
  return result;
}

}  // namespace phytobench
