// SPDX-License-Identifier: MIT
// Sec. 8.3, 9.2.6: normals from the Sobel operator and from the faces of a mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "core/terrain/relief.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/oracle_maps.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_relief.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

struct NamedEstimator {
  const char* name;
  SurfaceEstimator estimator;
};
constexpr std::array estimators = {
    NamedEstimator{"sobel", SurfaceEstimator::sobel},
    NamedEstimator{"six-faces", SurfaceEstimator::six_faces},
    NamedEstimator{"other-six-faces", SurfaceEstimator::other_six},
    NamedEstimator{"six-faces-weighing-the-same", SurfaceEstimator::unit_faces}};

/// Slope in degrees at the middle of five by five vertices.
template <class Height>
double slope_at_middle(double cell, const Height& height, SurfaceEstimator estimator) {
  return slope_degrees(surface_gradient(
      square_field(5, cell, [&](int column, int row) { return height(column - 2, row - 2); }), 2, 2,
      estimator));
}

void record_flat_and_planes(ExperimentContext& context) {
  double off_vertical = 0.0, spread = 0.0, off = 0.0, off_at_border = 0.0;
  const double planes[][2] = {{1.0, 0.0}, {0.0, std::sqrt(3.0)}, {0.3, -0.7}};
  for (const NamedEstimator& one : estimators) {
    const Vector3 normal = surface_normal(
        surface_gradient(HeightField(5, 5, thesis_cell, thesis_cell, 7.0), 2, 2, one.estimator));
    off_vertical =
        std::max({off_vertical, std::abs(normal.x), std::abs(normal.y), std::abs(normal.z - 1.0)});
    for (const auto& plane : planes) {
      const HeightField field = square_field(5, thesis_cell, [&](int column, int row) {
        return thesis_cell * (plane[0] * column + plane[1] * row);
      });
      const double truth = std::atan(std::hypot(plane[0], plane[1])) * (180.0 / std::numbers::pi);
      const double first = slope_degrees(surface_gradient(field, 2, 2, SurfaceEstimator::sobel));
      for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) {
          const double slope = slope_degrees(surface_gradient(field, column, row, one.estimator));
          double& worst = column == 2 && row == 2 ? off : off_at_border;
          worst = std::max(worst, std::abs(slope - truth));
          if (column == 2 && row == 2) spread = std::max(spread, std::abs(slope - first));
        }
    }
  }
  context.record("flat/off-vertical", off_vertical);
  context.record("plane-spread", spread, "degrees");
  context.record("plane-error", off, "degrees");
  context.record("plane-error/at-the-border", off_at_border, "degrees");
}

/// A plane of 45 degrees that rises southward, by the printed operator: without division by eight
/// cells, and with its y the other way round than the rows.
void record_printed_sobel(ExperimentContext& context) {
  const oracle::Heights south =
      oracle_map(square_field(3, thesis_cell, [](int, int row) { return thesis_cell * row; }));
  const oracle::Heights east = oracle_map(
      square_field(3, thesis_cell, [](int column, int) { return thesis_cell * column; }));
  context.record("sobel/sum-east", oracle::equation_8_3(east, 1, 1).S_x, "m");
  context.record("sobel/sum-south", oracle::equation_8_3(south, 1, 1).S_y, "m");
  context.record("sobel/printed/slope-of-45",
                 oracle::angle_to_vertical(oracle::sobel_as_printed(east, 1, 1)), "degrees");
  context.record("sobel/corrected/slope-of-45",
                 oracle::angle_to_vertical(oracle::sobel_corrected(east, 1, 1)), "degrees");
}

/// Sec. 8.3: the mesh has true coordinates; with numbers of pixels for metres slopes are too steep.
void record_coordinates(ExperimentContext& context) {
  const auto plane = [](int column, int) { return thesis_cell * column; };
  const auto slope = [&](double cell) {
    return slope_at_middle(cell, plane, SurfaceEstimator::six_faces);
  };
  context.record("coordinates/real", slope(thesis_cell), "degrees");
  context.record("coordinates/pixels", slope(1.0), "degrees");
  const auto tangent = [&](double cell) {
    return std::tan(slope(cell) * std::numbers::pi / 180.0);
  };
  context.record("coordinates/tangent-of-10-m-over-100-m", tangent(10.0) / tangent(100.0));
}

/// Heights around a vertex at random: the faces one by one against the closed form that core uses,
/// and what the vertex' own height changes.
void record_closed_form(ExperimentContext& context) {
  CounterStream stream(context.seed(), 60);
  double off = 0.0, centre = 0.0, norm_error = 0.0;
  constexpr std::pair<SurfaceEstimator, std::pair<oracle::Diagonal, oracle::FaceWeight>> pairs[] = {
      {SurfaceEstimator::six_faces,
       {oracle::Diagonal::south_west_north_east, oracle::FaceWeight::area}},
      {SurfaceEstimator::other_six,
       {oracle::Diagonal::north_west_south_east, oracle::FaceWeight::area}},
      {SurfaceEstimator::unit_faces,
       {oracle::Diagonal::south_west_north_east, oracle::FaceWeight::unit}}};
  for (int trial = 0; trial < 100; ++trial) {
    HeightField field =
        square_field(3, thesis_cell, [&](int, int) { return 50.0 * stream.next_unit(); });
    for (const auto& [estimator, face] : pairs) {
      const Vector3 n = surface_normal(surface_gradient(field, 1, 1, estimator));
      const oracle::Normal m =
          oracle::normal_of_six_faces(oracle_map(field), 1, 1, face.first, face.second);
      off = std::max({off, std::abs(n.x - m.x), std::abs(n.y - m.y), std::abs(n.z - m.z)});
      norm_error = std::max(norm_error, std::abs(norm(n) - 1.0));
    }
    // By area, and with Sobel, the middle does not count.
    HeightField needle = field;
    needle.at(1, 1) += 1000.0;
    for (const SurfaceEstimator estimator :
         {SurfaceEstimator::sobel, SurfaceEstimator::six_faces, SurfaceEstimator::other_six})
      centre = std::max(centre, std::abs(slope_degrees(surface_gradient(field, 1, 1, estimator)) -
                                         slope_degrees(surface_gradient(needle, 1, 1, estimator))));
  }
  context.record("closed-form", off);
  context.record("norm-error", norm_error);
  context.record("changed-by-own-height", centre, "degrees");
}

/// sin x cos y + x^3 / 10 + x^2 y / 20 at (0.7, 0.4).
void record_convergence(ExperimentContext& context) {
  const double x_0 = 0.7, y_0 = 0.4;
  const double gradient_x = std::cos(x_0) * std::cos(y_0) + 0.3 * x_0 * x_0 + 0.1 * x_0 * y_0,
               gradient_y = -std::sin(x_0) * std::sin(y_0) + 0.05 * x_0 * x_0;
  const double truth = std::atan(std::hypot(gradient_x, gradient_y)) * (180.0 / std::numbers::pi);
  int halvings = 0;
  for (const double cell : {0.2, 0.1, 0.05, 0.025}) {
    const auto height = [&](int column, int row) {
      const double x = x_0 + column * cell, y = y_0 + row * cell;
      return std::sin(x) * std::cos(y) + 0.1 * x * x * x + 0.05 * x * x * y;
    };
    for (const NamedEstimator& one : estimators)
      context.record(fmt::format("error/{}/{}/degrees", one.name, halvings),
                     std::abs(slope_at_middle(cell, height, one.estimator) - truth), "degrees");
    context.record(fmt::format("error/{}/cell", halvings++), cell, "m");
  }
}

/// Where the weighting of faces matters, and where no estimator sees what is there.
void record_creases(ExperimentContext& context) {
  for (const NamedEstimator& one : estimators) {
    const auto record = [&](const char* shape, const auto& height) {
      context.record(fmt::format("{}/{}", shape, one.name),
                     slope_at_middle(thesis_cell, height, one.estimator), "degrees");
    };
    record("crease", [](int column, int) { return thesis_cell * std::max(column, 0); });
    record("cliff", [](int column, int) { return column > 0 ? 160.0 : 0.0; });
    record("needle", [](int column, int row) { return column == 0 && row == 0 ? 1000.0 : 0.0; });
    record("roof", [](int column, int) { return -thesis_cell * std::abs(column); });
  }
}

/// Sec. 11.2: a surface that looks into the wind has the larger angle between its normal and where
/// the wind blows.
void record_wind(ExperimentContext& context) {
  const Vector3 eastward{1.0, 0.0, 0.0};
  const auto angle = [&](double rise) {
    return std::acos(dot(surface_normal({rise, 0.0}), eastward)) * (180.0 / std::numbers::pi);
  };
  context.record("wind/towards-it", angle(std::tan(std::numbers::pi / 6.0)), "degrees");
  context.record("wind/level", angle(0.0), "degrees");
  context.record("wind/away-from-it", angle(-std::tan(std::numbers::pi / 6.0)), "degrees");
}

void run(ExperimentContext& context) {
  record_flat_and_planes(context);
  record_printed_sobel(context);
  record_coordinates(context);
  record_closed_form(context);
  record_convergence(context);
  record_creases(context);
  record_wind(context);
}

}  // namespace

extern const ExperimentDescriptor relief;
constinit const ExperimentDescriptor relief{
    .id = "lesser2019/relief",
    .question = "Which way does the surface look, by the methods of the thesis?",
    .source = "[Lesser2019] sec. 8.3, 9.2.6, 11.2, eq. 8.2, 8.3",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
