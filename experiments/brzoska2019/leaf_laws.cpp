// SPDX-License-Identifier: MIT
// What leaves are made of, which branches carry how many, and how place, size and direction are
// distributed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random/counter_stream.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"
#include "core/statistics/running_moments.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/leaves.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr double tip_radius = 0.007;
constexpr std::size_t nodes = 50'000;  // that may carry leaves

/// A straight branch of edges of length 1, so that a leaf's x says on which edge it sits and where.
Skeleton straight_branch() {
  Skeleton branch({0, 0, 0});
  for (std::size_t i = 1; i <= nodes; ++i)
    branch.append(static_cast<std::int32_t>(i) - 1, {static_cast<double>(i), 0, 0});
  return branch;
}

/// The node at the upper end of a leaf's edge.
std::size_t node_of(const Leaf& leaf) {
  return static_cast<std::size_t>(std::floor(leaf.position.x)) + 1;
}

/// Something random, with the seed and the size of the sample.
void record_sample(ExperimentContext& context, const std::string& name, RecordValue value,
                   std::size_t size) {
  context.record({.experiment = {},
                  .measurement = name,
                  .value = std::move(value),
                  .sample_size = whole(size),
                  .seed = context.seed()});
}

/// Of a mesh of leaves, how far its squares are from squares, and those of one leaf from standing
/// on each other.
void record_shape(ExperimentContext& context, const std::string& name, LeafShape shape,
                  std::span<const Leaf> leaves) {
  const TriangleMesh mesh = mesh_leaves(leaves, shape);
  const std::size_t per_leaf = mesh.vertex_count() / leaves.size();
  double sides = 0.0, corners = 0.0, centers = 0.0, across = 0.0;
  for (std::size_t first = 0; first < mesh.vertex_count(); first += 4) {
    const Leaf& leaf = leaves[first / per_leaf];
    Vector3 sum;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3& at = mesh.positions[first + i];
      const Vector3 next = mesh.positions[first + (i + 1) % 4] - at;
      const Vector3 before = mesh.positions[first + (i + 3) % 4] - at;
      sides = std::max(sides, std::abs(norm(next) / leaf.size - 1.0));
      corners = std::max(corners, std::abs(dot(next, before)) / (leaf.size * leaf.size));
      sum = sum + at;
    }
    centers = std::max(centers, norm(sum / 4.0 - leaf.position));
    if (per_leaf == 16 && first % per_leaf < 8)
      across = std::max(across, std::abs(dot(mesh.normals[first], mesh.normals[first + 8])));
  }
  context.record(name + "/vertices", whole(mesh.vertex_count()));
  context.record(name + "/triangles", whole(mesh.triangle_count()));
  context.record(name + "/max_side_error", sides);
  context.record(name + "/max_corner_error", corners);
  context.record(name + "/max_center_error", centers, "length");
  if (shape == LeafShape::cross_foil) context.record(name + "/max_normal_product", across);
}

/// Leaves per node at a density of 2.3: whole part and fraction.
void record_fraction(ExperimentContext& context, const Skeleton& branch,
                     const std::vector<double>& radii) {
  std::vector<std::int64_t> at_node(branch.node_count(), 0);
  for (const Leaf& leaf : make_leaves(branch, radii, {.per_node = 2.3, .seed = context.seed()}))
    ++at_node[node_of(leaf)];
  RunningMoments moments;
  std::int64_t others = 0;
  for (std::size_t node = 1; node < at_node.size(); ++node) {
    moments.add(static_cast<double>(at_node[node]));
    others += at_node[node] != 2 && at_node[node] != 3;
  }
  record_sample(context, "fraction/mean", moments.mean(), nodes);
  record_sample(context, "fraction/variance", moments.variance(), nodes);
  record_sample(context, "fraction/neither_2_nor_3", others, nodes);
}

/// Every third edge is too thick, by different amounts; the radius limit itself is too thick.
void record_radius_limit(ExperimentContext& context, const Skeleton& branch) {
  const LeafOptions options{.per_node = 1.0, .seed = context.seed()};
  std::vector<double> radii(branch.node_count(), tip_radius);
  for (std::size_t i = 0; i < radii.size(); i += 3)
    radii[i] = options.radius_limit * (1.0 + static_cast<double>(i % 5));
  std::int64_t on_thick = 0, on_thin = 0;
  for (const Leaf& leaf : make_leaves(branch, radii, options))
    ++(radii[node_of(leaf)] < options.radius_limit ? on_thin : on_thick);
  context.record("radius_limit/thin_nodes",
                 whole(leaf_bearing_nodes(branch, radii, options.radius_limit)));
  context.record("radius_limit/leaves_on_thin", on_thin);
  context.record("radius_limit/leaves_on_thick", on_thick);
}

double normal_share_below(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

void record_distributions(ExperimentContext& context, const std::vector<Leaf>& leaves,
                          const LeafOptions& options) {
  std::vector<double> places, sizes, heights;
  RunningMoments size, up;
  std::int64_t not_positive = 0;
  for (const Leaf& leaf : leaves) {
    const double share = leaf.size / options.size;
    const double upward = leaf.turned({0, 1, 0}).y;
    places.push_back(leaf.position.x - std::floor(leaf.position.x));
    sizes.push_back(normal_share_below((share - 1.0) / options.size_spread));
    heights.push_back(0.5 * (upward + 1.0));  // of points uniform on a sphere it is uniform
    size.add(share);
    up.add(upward);
    not_positive += !(leaf.size > 0.0);
  }
  const std::size_t n = leaves.size();
  context.record("places/leaves", whole(n));
  record_sample(context, "places/uniformity_p_value", kolmogorov_uniformity_p_value(places), n);
  record_sample(context, "size/mean_over_given", size.mean(), n);
  record_sample(context, "size/deviation_over_given", size.deviation(), n);
  record_sample(context, "size/normality_p_value", kolmogorov_uniformity_p_value(sizes), n);
  record_sample(context, "size/not_positive", not_positive, n);
  record_sample(context, "direction/uniform_turn/mean_upward", up.mean(), n);
  record_sample(context, "direction/uniform_turn/uniformity_p_value",
                kolmogorov_uniformity_p_value(heights), n);
}

/// The other way to read "a random orientation": any axis, any angle.
void record_axis_and_angle(ExperimentContext& context, std::size_t count) {
  CounterStream stream(context.seed(), 52);
  RunningMoments up;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = stream.next_between(-1.0, 1.0), around = stream.next_unit();
    const double r = std::sqrt(1.0 - y * y), phi = 2.0 * std::numbers::pi * around;
    const Vector3 axis{r * std::cos(phi), y, r * std::sin(phi)};
    const Rotation turn = Rotation::about(axis, 2.0 * std::numbers::pi * stream.next_unit());
    up.add(turn({0, 1, 0}).y);
  }
  record_sample(context, "direction/axis_and_angle/mean_upward", up.mean(), count);
}

/// Whether leaves high in a crown, with more light, look elsewhere than low ones.
void record_light(ExperimentContext& context, const std::vector<Leaf>& leaves) {
  RunningMoments heights, ups, products;
  for (const Leaf& leaf : leaves) {
    heights.add(leaf.position.y);
    ups.add(leaf.turned({0, 1, 0}).y);
    products.add(leaf.position.y * leaf.turned({0, 1, 0}).y);
  }
  const double covariance = products.mean() - heights.mean() * ups.mean();
  record_sample(context, "direction/figure-40/correlation_with_height",
                covariance / (heights.deviation() * ups.deviation()), leaves.size());
  context.record("direction/figure-40/leaves", whole(leaves.size()));
}

/// The plants of the figures: nodes thin enough for leaves, and nodes with a single tip above.
void record_figures(ExperimentContext& context) {
  for (const char* row : {"figure-40-right", "figure-41-middle", "figure-42-right",
                          "figure-43-right", "figure-44-right", "figure-45-right"}) {
    const TreeParameters parameters = thesis_tree(row);
    const Skeleton tree = grow_thesis_tree(parameters, context.threads());
    const PlantParameters& look = parameters.plant;
    const std::vector<double> radii = branch_radii(tree, look.tip_radius, look.radius_exponent);
    const std::vector<std::int32_t> tips = tips_above(tree);
    context.record(std::string(row) + "/thin_nodes",
                   whole(leaf_bearing_nodes(tree, radii, look.leaves.radius_limit)));
    context.record(std::string(row) + "/nodes_with_one_tip",
                   std::int64_t{std::count(tips.begin() + 1, tips.end(), 1)});
    if (row != std::string("figure-40-right")) continue;
    LeafOptions many = look.leaves;
    many.per_node = 10.0;
    many.seed = context.seed();
    record_light(context, make_leaves(tree, radii, many));
  }
}

void run(ExperimentContext& context) {
  const Skeleton branch = straight_branch();
  const std::vector<double> radii(branch.node_count(), tip_radius);
  const LeafOptions options{.per_node = 1.0, .seed = context.seed()};
  const std::vector<Leaf> leaves = make_leaves(branch, radii, options);
  constexpr std::size_t meshed = 1000;
  record_shape(context, "cross_foil", LeafShape::cross_foil, std::span(leaves).first(meshed));
  record_shape(context, "square", LeafShape::square, std::span(leaves).first(meshed));
  context.record("meshed_leaves", whole(meshed));
  record_distributions(context, leaves, options);
  record_axis_and_angle(context, leaves.size());
  record_fraction(context, branch, radii);
  record_radius_limit(context, branch);
  record_figures(context);
}

}  // namespace

extern const ExperimentDescriptor leaf_laws;
constinit const ExperimentDescriptor leaf_laws{
    .id = "brzoska2019/leaf-laws",
    .question =
        "What are leaves made of, where do they grow, and how are place, size and "
        "direction distributed?",
    .source = "[Brzoska2019] sec. 3.5, 5.1, 6.1.1, fig. 24",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
