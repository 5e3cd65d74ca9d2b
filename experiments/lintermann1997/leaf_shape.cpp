// SPDX-License-Identifier: MIT
// Sec. 4 and 5.1: what outline, fold, bend and waves make of a leaf.
#include <array>

#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/tree/mesh_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr std::array half_widths{0.1, 0.8, 1.0, 0.5, 0.0};
constexpr int rows_per_span = 12;
constexpr std::size_t rows = 4 * rows_per_span + 1, columns = 3;  // edge, middle, edge

/// Half as wide as long; the upper side is meshed first, row after row.
TriangleMesh leaf(const std::string& keys) {
  return SingleComponent("leaf",
                         fmt::format("length = 2\nwidth = 1\noutline = [{}]\npieces_along = {}\n"
                                     "pieces_per_half = 1\n{}",
                                     fmt::join(half_widths, ", "), rows - 1, keys))
      .mesh();
}

const Vector3& edge_at(const TriangleMesh& mesh, std::size_t row) {
  return mesh.positions[row * columns + 2];
}
const Vector3& middle_at(const TriangleMesh& mesh, std::size_t row) {
  return mesh.positions[row * columns + 1];
}

void record_outline(ExperimentContext& context) {
  const TriangleMesh mesh = leaf("fold = 0\nbend = 0");
  double from_points = 0.0, trapezia = 0.0, kink = 0.0;
  for (std::size_t i = 0; i < half_widths.size(); ++i)
    from_points = std::fmax(
        from_points, std::abs(std::abs(edge_at(mesh, i * rows_per_span).x) - 0.5 * half_widths[i]));
  const auto width = [&](std::size_t row) { return 2.0 * std::abs(edge_at(mesh, row).x); };
  const double step = 2.0 / static_cast<double>(rows - 1);
  for (std::size_t row = 1; row < rows; ++row)
    trapezia += 0.5 * step * (width(row - 1) + width(row));
  for (std::size_t row = 1; row + 1 < rows; ++row)
    kink = std::fmax(kink, std::abs(width(row + 1) - 2.0 * width(row) + width(row - 1)) / step);
  context.record("outline/deviation_from_its_points", from_points, "length");
  context.record("outline/greatest_change_of_slope", kink);
  context.record("outline/area_ratio_to_trapezia", surface_area(mesh) / (2.0 * trapezia));
}

void record_fold(ExperimentContext& context) {
  for (const double fold : {0.0, 15.0, 40.0}) {
    const TriangleMesh mesh = leaf(fmt::format("fold = {}\nbend = 0", fold));
    const std::size_t widest = 2 * rows_per_span;
    const Vector3 half = edge_at(mesh, widest) - middle_at(mesh, widest);
    const Vector3 other = mesh.positions[widest * columns] - middle_at(mesh, widest);
    context.record(fmt::format("fold-{:.0f}/angle_between_halves", fold), angle_deg(half, other),
                   "degrees");
  }
}

void record_bend(ExperimentContext& context) {
  const SingleComponent bent("leaf", "length = 2\nbend = 70\npieces_along = 400");
  context.record("bend-70/turn_of_tip", angle_deg(bent.child().y, {0.0, 1.0, 0.0}), "degrees");
  const TriangleMesh mesh = bent.mesh();
  double length = 0.0;
  constexpr std::size_t per_row = 5;  // two columns of triangles on either side
  for (std::size_t row = 1; row <= 400; ++row)
    length += norm(mesh.positions[row * per_row + 2] - mesh.positions[(row - 1) * per_row + 2]);
  context.record("bend-70/length_ratio", length / 2.0);
}

/// Three waves: the sign of the edge's height changes five times between base and tip.
void record_waves(ExperimentContext& context) {
  const TriangleMesh mesh = leaf("fold = 0\nbend = 0\nwave_height = 0.2\nwaves = 3");
  double highest = 0.0, middle = 0.0, before = 0.0;
  std::int64_t changes = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double width = 2.0 * std::abs(edge_at(mesh, row).x), height = edge_at(mesh, row).z;
    middle = std::fmax(middle, std::abs(middle_at(mesh, row).z));
    if (width > 0.0) highest = std::fmax(highest, std::abs(height) / width);
    constexpr double flat = 1e-12;
    if (std::abs(height) < flat) continue;
    changes += before * height < 0.0;
    before = height;
  }
  context.record("waves-3/height_by_width", highest);
  context.record("waves-3/changes_of_sign", changes);
  context.record("waves-3/height_of_middle", middle, "length");
}

void run(ExperimentContext& context) {
  record_outline(context);
  record_fold(context);
  record_bend(context);
  record_waves(context);
}

}  // namespace

extern const ExperimentDescriptor leaf_shape;
constinit const ExperimentDescriptor leaf_shape{
    .id = "lintermann1997/leaf-shape",
    .question = "How do outline, fold, bend and waves shape a leaf?",
    .source = "[Lintermann1997] sec. 4, 5.1",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
