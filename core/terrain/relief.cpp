// SPDX-License-Identifier: MIT
#include "core/terrain/relief.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

struct Offset {
  int column;
  int row;
};

/// Heights around a vertex, as far as they are there.
class Surroundings {
 public:
  Surroundings(const HeightField& field, int column, int row)
      : field_(field), column_(column), row_(row) {}

  /// NaN off the map and without data.
  double height(const Offset& offset) const {
    const int column = column_ + offset.column, row = row_ + offset.row;
    const bool is_on_map =
        column >= 0 && column < field_.columns() && row >= 0 && row < field_.rows();
    return is_on_map ? field_.at(column, row) : HeightField::no_data;
  }
  /// The same, but what is missing lies on the line from the opposite neighbour through `middle`,
  /// which is the vertex itself or its neighbour in the same column or row.
  double extended_height(const Offset& offset, const Offset& middle) const {
    const double there = height(offset);
    if (!std::isnan(there)) return there;
    const Offset opposite{2 * middle.column - offset.column, 2 * middle.row - offset.row};
    return 2.0 * height(middle) - height(opposite);
  }
  double width() const { return field_.cell_width(); }
  double depth() const { return field_.cell_depth(); }

 private:
  const HeightField& field_;
  int column_;
  int row_;
};

/// The mean rise across three lines, that through the vertex twice; lines that are not there are
/// left out. NaN if none is.
struct WeightedRise {
  double sum = 0.0;
  double weight = 0.0;

  void add(double ahead, double behind, double line_weight) {
    if (std::isnan(ahead) || std::isnan(behind)) return;
    sum += line_weight * (ahead - behind);
    weight += line_weight;
  }
  double over(double distance) const { return sum / weight / distance; }
};

SurfaceGradient sobel(const Surroundings& around) {
  WeightedRise east, south;
  for (const int side : {-1, 0, 1}) {
    const double weight = side == 0 ? 2.0 : 1.0;
    const Offset in_row{0, side}, in_column{side, 0};
    east.add(around.extended_height({1, side}, in_row), around.extended_height({-1, side}, in_row),
             weight);
    south.add(around.extended_height({side, 1}, in_column),
              around.extended_height({side, -1}, in_column), weight);
  }
  return {east.over(2.0 * around.width()), south.over(2.0 * around.depth())};
}

/// Neighbours around a vertex in the order of their faces; each face has two that follow each
/// other. Columns run east, rows south.
constexpr std::array<Offset, 6> south_west_to_north_east = {
    {{1, 0}, {1, -1}, {0, -1}, {-1, 0}, {-1, 1}, {0, 1}}};
constexpr std::array<Offset, 6> north_west_to_south_east = {
    {{1, 0}, {0, -1}, {-1, -1}, {-1, 0}, {0, 1}, {1, 1}}};

SurfaceGradient from_faces(const Surroundings& around, std::span<const Offset, 6> ring,
                           bool by_area) {
  const double here = around.height({0, 0});
  const auto edge = [&](const Offset& to) {
    return Vector3{to.column * around.width(), to.row * around.depth(), around.height(to) - here};
  };
  Vector3 sum{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector3 a = edge(ring[i]), b = edge(ring[(i + 1) % ring.size()]);
    const Vector3 normal = cross(b, a);  // rows run south: the other way round points down
    if (std::isnan(normal.x) || std::isnan(normal.y)) continue;
    sum = sum + (by_area ? normal : normal / norm(normal));
  }
  return {-sum.x / sum.z, -sum.y / sum.z};
}

}  // namespace

SurfaceGradient surface_gradient(const HeightField& field, int column, int row,
                                 SurfaceEstimator estimator) {
  if (!field.has_data(column, row)) return {HeightField::no_data, HeightField::no_data};
  const Surroundings around(field, column, row);
  switch (estimator) {
    case SurfaceEstimator::sobel:
      return sobel(around);
    case SurfaceEstimator::six_faces:
      return from_faces(around, south_west_to_north_east, true);
    case SurfaceEstimator::other_six:
      return from_faces(around, north_west_to_south_east, true);
    case SurfaceEstimator::unit_faces:
      return from_faces(around, south_west_to_north_east, false);
  }
  PHYTOBENCH_ENSURE(!"a known estimator");
  return {};
}

Vector3 surface_normal(const SurfaceGradient& gradient) {
  const Vector3 upright{-gradient.east, -gradient.south, 1.0};
  return upright / norm(upright);
}

double slope_degrees(const SurfaceGradient& gradient) {
  return std::atan(std::hypot(gradient.east, gradient.south)) * (180.0 / std::numbers::pi);
}

std::vector<SurfaceGradient> surface_gradients(const HeightField& field, SurfaceEstimator estimator,
                                               int threads) {
  std::vector<SurfaceGradient> gradients(field.size());
  for_tasks(static_cast<std::size_t>(field.rows()), threads, [&](std::size_t row) {
    for (int column = 0; column < field.columns(); ++column)
      gradients[field.index(column, static_cast<int>(row))] =
          surface_gradient(field, column, static_cast<int>(row), estimator);
  });
  return gradients;
}

}  // namespace phytobench
