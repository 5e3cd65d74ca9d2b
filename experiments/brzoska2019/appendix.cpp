// SPDX-License-Identifier: MIT
// The appendix table: how many vertices and triangles the plants of the thesis' figures have.
#include "core/tree/plant.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

double vertices_per_leaf(LeafShape shape) {
  return shape == LeafShape::cross_foil ? 16.0 : 8.0;
}

/// Leaves are drawn at random: besides those of this seed, what the density gives on average.
void record_leaves(ExperimentContext& context, const std::string& row, const Plant& plant,
                   const LeafOptions& leaves) {
  const std::size_t bearing = leaf_bearing_nodes(plant.skeleton, plant.radii, leaves.radius_limit);
  const double expected = static_cast<double>(bearing) * leaves.per_node;
  const double per_leaf = vertices_per_leaf(leaves.shape);
  context.record(row + "/leaf_bearing_nodes", whole(bearing));
  context.record({.experiment = {},
                  .measurement = row + "/leaves",
                  .value = whole(plant.leaves.size()),
                  .seed = leaves.seed});
  context.record(row + "/expected_leaves", expected);
  context.record(row + "/expected_vertices",
                 static_cast<double>(plant.branches.mesh.vertex_count()) + per_leaf * expected);
  context.record(
      row + "/expected_triangles",
      static_cast<double>(plant.branches.mesh.triangle_count()) + 0.5 * per_leaf * expected);
}

/// Triangles over vertices of all rows.
struct MeshSizes {
  PlotCurve leafless{.name = "without leaves", .x = {}, .y = {}, .style = PlotStyle::points};
  PlotCurve leafy{.name = "with leaves", .x = {}, .y = {}, .style = PlotStyle::points};

  void add(const Plant& plant) {
    PlotCurve& curve = plant.leaves.empty() ? leafless : leafy;
    curve.x.push_back(static_cast<double>(plant.vertex_count()));
    curve.y.push_back(static_cast<double>(plant.triangle_count()));
  }
};

void draw(ExperimentContext& context, const MeshSizes& sizes) {
  add_plot(context, "appendix-table",
           {.title = "Triangles over vertices of the appendix' plants",
            .description = "A mark per plant of the table, as grown here, both axes logarithmic: "
                           "leaves add twice as many vertices as triangles, so that plants with "
                           "leaves have fewer triangles for their vertices.",
            .panels = {{.curves = {sizes.leafless, sizes.leafy},
                        .x_label = "vertices",
                        .y_label = "triangles",
                        .log_x = true,
                        .log_y = true}}});
}

void record_row(ExperimentContext& context, const std::string& row, MeshSizes& sizes) {
  context.progress("growing " + row);
  const TreeParameters parameters = thesis_tree(row);
  const Plant plant = make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
  context.record({.experiment = {},
                  .measurement = row + "/edges",
                  .value = whole(plant.skeleton.edge_count()),
                  .seed = parameters.seed});
  context.record(row + "/tips", whole(tip_count(plant.skeleton)));
  context.record(row + "/duplicated_rings", whole(plant.branches.duplicated_rings));
  context.record(row + "/vertices", whole(plant.vertex_count()));
  context.record(row + "/triangles", whole(plant.triangle_count()));
  context.record(row + "/branch_vertices", whole(plant.branches.mesh.vertex_count()));
  context.record(row + "/branch_triangles", whole(plant.branches.mesh.triangle_count()));
  record_leaves(context, row, plant, parameters.plant.leaves);
  sizes.add(plant);
}

void run(ExperimentContext& context) {
  MeshSizes sizes;
  for (const std::string& row : thesis_parameters().table("appendix").texts("rows"))
    record_row(context, row, sizes);
  draw(context, sizes);
}

}  // namespace

extern const ExperimentDescriptor appendix;
constinit const ExperimentDescriptor appendix{
    .id = "brzoska2019/appendix",
    .question = "How many vertices and triangles do the plants of the thesis' figures have?",
    .source = "[Brzoska2019] appendix table",
    .seconds = {2, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
